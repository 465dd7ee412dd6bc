#pragma once

#include <string>

#include "core/state.hpp"

namespace ligament {

/// 128-bit XXH3 hash (32 hex digits) of every field of the state that decides how the run goes on, bit by bit. Two runs
/// with the same hash continue the same way.
std::string state_hash(const State& state);

}  // namespace ligament
