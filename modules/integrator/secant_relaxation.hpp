#pragma once

#include "integrator/equilibrium_search.hpp"
#include "integrator/momentum_relaxation.hpp"
#include "integrator/spring_equilibrium.hpp"
#include "integrator/spring_flexibility.hpp"

namespace ligament {

/// Direct search: a factorised stiffness K for all of the structure but the *live* contacts, which do not keep to the
/// stiffness they have in K. What these few have to carry, with the law of each and the flexibility of the structure
/// between them, is solved apart (spring_equilibrium), and then answered by the whole,
///   u ← u + K⁻¹ (r - Σ b q) + Δt d,
/// r the resultants of free bodies, q what the springs b of live contacts pull more than K makes of it. Under the
/// control of a gauge the pseudo-time t is unknown as well; d is the answer to what a unit of time prescribes and
/// loads. K is made anew when too many contacts have left it. What does not settle so is left to momenta.
class SecantRelaxation : public EquilibriumSearch {
 public:
  void declare(Parameters& parameters) override;
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) override {
    momenta_.use_stiffness(model, state, stiffness);
  }
  [[nodiscard]] bool extrapolates() const override { return false; }
  [[nodiscard]] std::int64_t most_evaluations_of_smooth_increment() const override { return 5; }
  [[nodiscard]] bool follows_gauges() const override { return true; }
  bool find(Increment& increment, const IncrementTarget& target) override;
  bool find_live(Increment& increment, double step) override;

 private:
  /// How far the increment has come on its way.
  struct Course {
    std::span<const SpringTerm> gauge;
    double unit = 0.0;                    ///< of time (s)
    double time = 0.0;                    ///< so far (units)
    double gauge_left = 0.0;              ///< to go
    double gauge_rate = 1.0;              ///< of the gauge along d
    std::vector<double> gauge_half = {};  ///< half the answer to the gauge's factors as forces
  };

  bool find_directly(Increment& increment, const IncrementTarget& target);
  /// Sees to it that there is a K for the increment.
  void prepare(Increment& increment);
  void factorise(Increment& increment, std::vector<double> secants, std::vector<double> places);
  /// Of an increment that has found its equilibrium.
  void remember_stiffness(LoadingState& loading) const;
  [[nodiscard]] Course begin_course(Increment& increment, const IncrementTarget& target);
  /// Takes contacts off K that do not keep to it, to a tolerance (N).
  void find_live_contacts(const std::vector<LooseContact>& loose, double tolerance);
  /// What live contacts have to solve, with the half of the answer to the resultants, and the pseudo-time (units) to
  /// which the gauge comes if they kept to K.
  [[nodiscard]] SpringProblem live_problem(const Increment& increment, const std::vector<LooseContact>& loose,
                                           const std::vector<double>& half, double advance);
  /// Holds the gauge where it is, whatever live springs pull: pseudo-time, so much for a unit of each (units/N), makes
  /// up for it.
  std::vector<double> hold_gauge(const Course& course, SpringProblem& problem) const;
  /// The next motion, and the pseudo-time that goes with it (units). Nothing if live contacts do not settle.
  [[nodiscard]] std::optional<std::vector<double>> correction(Increment& increment, Course& course);

  std::int64_t most_changed_ = 300;
  /// choice: what a direct search cannot settle has lost its stiffness, and costs many evaluations with either mass.
  MomentumRelaxation momenta_{MomentumRelaxation::Masses::two_level};

  // Scratch; K is that of the state.
  SpringFlexibility flexibility_;
  std::vector<double> secants_;  ///< in K
  std::vector<double> places_;   ///< displacements for which K was made
  std::int64_t update_ = 0;      ///< of contacts, see SearchState::n_updates
  // Of an increment.
  std::vector<double> direction_;     ///< d
  std::vector<std::size_t> live_;     ///< normal springs of live contacts, ascending
  std::vector<std::size_t> springs_;  ///< both springs of each
};

}  // namespace ligament
