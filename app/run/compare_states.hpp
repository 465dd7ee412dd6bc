#pragma once

#include <optional>
#include <string>

#include "core/state.hpp"

namespace ligament {

/// The first place where two states differ, bit by bit, in words: field, index and both values.
std::optional<std::string> first_difference(const State& a, const State& b);

}  // namespace ligament
