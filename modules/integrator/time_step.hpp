#pragma once

#include <string>

#include "core/model.hpp"
#include "core/state.hpp"
#include "core/stiffness_bounds.hpp"

namespace ligament {

/// The largest stable step and the body that sets it.
struct CriticalTimeStep {
  double time_step = 0.0;  ///< 2/ω, ω²= max bound/mass (s); infinite if nothing has stiffness
  std::string limiting_body;
};
CriticalTimeStep critical_time_step(const Model& model, const State& state, const StiffnessBounds& bounds);

/// Masses of the model's densities; I = ½ m R² (discs).
void use_real_masses(const Model& model, State& state);

/// Masses that make the time step stable for every body, m = (Δt²/4) · bound · safety (Underwood). A body that feels no
/// stiffness gets the mean mass of the others.
void use_scaled_masses(const Model& model, State& state, const StiffnessBounds& bounds, double safety);

/// Raises scaled masses to the above where they no longer suffice even without safety, velocities kept; returns the
/// energy ½ Δm v(n-½)² (J) this brings.
double raise_scaled_masses(const Model& model, State& state, const StiffnessBounds& bounds, double safety);

}  // namespace ligament
