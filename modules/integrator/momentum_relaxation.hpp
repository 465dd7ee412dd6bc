#pragma once

#include <memory>
#include <optional>

#include "integrator/adaptive_momenta.hpp"
#include "integrator/equilibrium_search.hpp"
#include "integrator/relaxation_mass.hpp"

namespace ligament {

/// Relaxes increments with momenta and adaptive damping.
class MomentumRelaxation : public EquilibriumSearch {
 public:
  /// What increments are relaxed with, unless contacts live.
  enum class Masses { stiffness, two_level };

  explicit MomentumRelaxation(Masses usual = Masses::stiffness) : masses_(usual) {}

  void declare(Parameters& parameters) override;
  /// A jump begins slowly: with four times as much, increments pass for settled whose equilibrium is about to be lost.
  /// What settles at all has done so within a thousand evaluations.
  [[nodiscard]] EquilibriumCriterion usual_criterion() const override {
    return {.unbalanced_ratio = 1.25e-3, .force_mismatch = 2.5e-4, .most_evaluations = 1000};
  }
  /// Makes the masses, from those of the state.
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) override;
  [[nodiscard]] bool extrapolates() const override { return true; }
  [[nodiscard]] std::int64_t most_evaluations_of_smooth_increment() const override { return 150; }
  [[nodiscard]] std::int64_t most_evaluations_of_steady_increment() const override { return 30; }
  bool find(Increment& increment, const IncrementTarget& target) override;
  bool find_live(Increment& increment, double step) override;

 private:
  /// Moves as the last increment did; if that may have held a jump, as it began, where this leaves less to relax.
  void move_as_before(Increment& increment, double step);
  /// r·M⁻¹ r of the resultants on free bodies (J).
  [[nodiscard]] double unbalance(const Increment& increment);
  /// Relaxes free freedoms, while prescribed ones still take so many parts of their motion.
  bool relax(Increment& increment, const std::vector<double>& part, std::int64_t n_parts);
  [[nodiscard]] RelaxationMass& mass(bool is_live) const;

  DampingBounds bounds_;
  Masses masses_;
  std::optional<double> coarse_cell_;
  std::unique_ptr<RelaxationMass> stiffness_mass_;
  std::unique_ptr<RelaxationMass> two_level_mass_;
};

}  // namespace ligament
