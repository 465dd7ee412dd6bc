#pragma once

#include <string>
#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// Bodies, joined by elements and bonds, that their supports leave free to move as a whole, each in words: what it is,
/// which motions are free and what would do. A static run of them has no answer. Only the first ten are described.
std::vector<std::string> find_unsupported_bodies(const Model& model, const State& state);

}  // namespace ligament
