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
  [[nodiscard]] std::int64_t most_evaluations_of_smooth_increment() const override { return 150; }
  bool find(Increment& increment, const IncrementTarget& target) override;
  bool find_live(Increment& increment, double step) override;

 private:
  /// Relaxes free freedoms, while prescribed ones still take so many parts of their motion.
  bool relax(Increment& increment, const std::vector<double>& part, std::int64_t n_parts);

  DampingBounds bounds_;
  std::optional<double> coarse_cell_;
  std::optional<TwoLevelMass> mass_;
};

}  // namespace ligament
