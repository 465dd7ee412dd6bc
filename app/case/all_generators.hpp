#pragma once

#include <memory>
#include <string>

#include "case/input_files.hpp"
#include "core/generator.hpp"
#include "core/registry.hpp"

namespace ligament {

/// All that can fill the zone of that name: the generators, and the file of an assembly.
Registry<Generator> all_generators(const std::shared_ptr<InputFiles>& files, const std::string& zone);

}  // namespace ligament
