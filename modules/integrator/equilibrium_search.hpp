#pragma once

#include <span>

#include "integrator/increment.hpp"

namespace ligament {

/// What an increment is to bring.
struct IncrementTarget {
  double step = 0.0;  ///< of pseudo-time (s), or of the gauge
  /// Displacements whose weighted sum the gauge is; without any the step is one of pseudo-time.
  std::span<const SpringTerm> gauge = {};
  double usual_time = 0.0;  ///< for pseudo-time that the gauge asks for: what an increment takes about (s)
};

/// How an increment of loading is brought to equilibrium.
class EquilibriumSearch {
 public:
  virtual ~EquilibriumSearch() = default;

  /// Its parameters, read from the table [solver].
  virtual void declare(class Parameters& parameters) = 0;
  /// What counts as equilibrium unless the case says otherwise: what keeps peak and work of fracture runs within a
  /// percent.
  [[nodiscard]] virtual EquilibriumCriterion usual_criterion() const { return {}; }
  /// Called once at set-up, after bodies have their masses.
  virtual void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) = 0;
  /// Whether it starts from the motion of an increment before; of a stage that begins, that of a small one.
  [[nodiscard]] virtual bool extrapolates() const = 0;

  /// An increment that takes more evaluations of the forces holds a jump, on whose way bonds break.
  [[nodiscard]] virtual std::int64_t most_evaluations_of_smooth_increment() const = 0;

  /// One that takes more may hold a jump, which will not come again: the motion with which it began is remembered, too.
  [[nodiscard]] virtual std::int64_t most_evaluations_of_steady_increment() const {
    return most_evaluations_of_smooth_increment();
  }

  /// Whether it can follow a gauge.
  [[nodiscard]] virtual bool follows_gauges() const { return false; }

  /// Finds the equilibrium. False if it does not settle before the increment is exhausted.
  virtual bool find(Increment& increment, const IncrementTarget& target) = 0;
  /// The same of a step of pseudo-time (s) in a live increment. False also if it knows no way to do so.
  virtual bool find_live(Increment& /*increment*/, double /*step*/) { return false; }
};

}  // namespace ligament
