#pragma once

#include <optional>

#include "integrator/adaptive_momenta.hpp"
#include "integrator/equilibrium_search.hpp"
#include "integrator/two_level_mass.hpp"

namespace ligament {

/// Relaxes increments with masses of two levels and adaptive damping.
class MomentumRelaxation : public EquilibriumSearch {
 public:
  void declare(Parameters& parameters) override;
  /// Makes the masses, from those of the state.
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) override;
  [[nodiscard]] bool extrapolates() const override { return true; }
  bool find(Increment& increment, const IncrementTarget& target) override;

 private:
  DampingBounds bounds_;
  std::optional<double> coarse_cell_;
  std::optional<TwoLevelMass> mass_;
};

}  // namespace ligament
