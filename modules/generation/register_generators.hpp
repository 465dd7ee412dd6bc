#pragma once

#include "core/generator.hpp"
#include "core/registry.hpp"

namespace ligament {

/// All particle generators by name.
Registry<Generator> generators();

}  // namespace ligament
