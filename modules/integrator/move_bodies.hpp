#pragma once

#include "core/state.hpp"

namespace ligament {

/// u(n) = u(n-1) + v(n-½) Δt, likewise rotations, for all bodies.
void move_bodies(State& state);

}  // namespace ligament
