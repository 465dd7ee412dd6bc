#pragma once

#include "case/case.hpp"
#include "core/state.hpp"

namespace ligament {

/// Asks the law of every bond of set-up whether it can serve it. Adds an error to the case for the worst contact of
/// each material: one that would snap back, with the least fracture energy that would do.
void check_contacts(Case& input, const Model& model, const State& state);

}  // namespace ligament
