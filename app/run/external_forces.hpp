#pragma once

#include <optional>

#include "integrator/prescribed_motion.hpp"
#include "simulation.hpp"

namespace ligament {

/// What acts on the structure from outside; in equilibrium the two balance each other.
struct ExternalForces {
  Vector driving{};     ///< loads, gravity, and what moves bodies at prescribed velocities (N)
  Vector supporting{};  ///< reactions of supports (N)

  /// What is missing to balance (N).
  [[nodiscard]] double lacking() const { return norm(driving + supporting); }
  /// The same, as a share of the driving force; nothing without a driving resultant.
  [[nodiscard]] std::optional<double> mismatch() const;
};

/// Sums them over all bodies at time n. `freedoms` are all that are prescribed.
ExternalForces external_forces(const Simulation& simulation, const std::vector<PrescribedFreedom>& freedoms);

}  // namespace ligament
