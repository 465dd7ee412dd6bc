#pragma once

#include <string>

#include "core/integrator.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// How far particles may move in one step (m), and turn (rad).
/// choice: by the smallest diameter. A stable step moves a particle that far only if it is as fast as sound; what is
/// faster passes its neighbours before the search sees them. Elements are linear: their nodes need only be finite.
struct StepLimits {
  double travel = 0.0;
  double turn = 3.0;
};
StepLimits step_limits(const Model& model);

/// Whether all bodies have moved within the limits in a step.
bool is_within(const StepTravel& travel, const StepLimits& limits);

/// The first body with a number that is not finite, where it is, and which of its contacts or elements has the largest
/// force or stress; empty if all are finite.
std::string describe_infinite_body(const Model& model, const State& state);

/// The same for the first body that is not finite or beyond the limits.
std::string describe_lost_body(const Model& model, const State& state, const StepLimits& limits);

}  // namespace ligament
