#pragma once

#include <string>

namespace ligament::benchmarks {

/// Registers the whole step of a case file.
void register_case_step(const std::string& path);

}  // namespace ligament::benchmarks
