#pragma once

#include <optional>
#include <vector>

#include "core/state.hpp"
#include "integrator/coarse_space.hpp"
#include "integrator/relaxation_mass.hpp"

namespace ligament {

/// Masses of two levels: those scaled body by body, D, and those of coarse motions of the whole structure,
/// M⁻¹ = a (D⁻¹ + Z K_c⁻¹ Zᵀ), for steps of 1 s of pseudo-time. Slow motions get masses that fit them.
class TwoLevelMass : public RelaxationMass {
 public:
  /// D are the masses of the state; coarse cells are of this size (m), or half of the shorter side of the structure.
  TwoLevelMass(const Model& model, const State& state, const StiffnessSum& stiffness,
               std::optional<double> coarse_cell);

  [[nodiscard]] std::vector<double> velocities(const std::vector<double>& momenta) override;

 private:
  CoarseSpace coarse_;
  std::vector<double> inverse_mass_;  ///< a / D of free freedoms, 0 of the others
  double scale_ = 1.0;                ///< a
};

}  // namespace ligament
