#pragma once

#include "core/integrator.hpp"
#include "core/state.hpp"

namespace ligament {

/// u(n) = u(n-1) + v(n-½) Δt, likewise rotations, for all bodies. Returns how far they went.
StepTravel move_bodies(State& state);

}  // namespace ligament
