#pragma once

#include <string>

namespace ligament {

/// "0.1.0".
std::string program_version();
/// Kind of build: "Release", with "+audit" where every step is checked.
std::string program_build();
/// Compiler and its version.
std::string program_compiler();

}  // namespace ligament
