#pragma once

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// Adds the walls of a case to a model whose particles and elements are complete, each facing the particles. What is
/// wrong with them becomes errors of the case file.
void add_walls(Case& input, Model& model);

/// Walls that nothing can touch become errors of the case file.
void refuse_idle_walls(Case& input, const Model& model, const State& state);

}  // namespace ligament
