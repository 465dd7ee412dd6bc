#pragma once

#include "integrator/increment.hpp"

namespace ligament {

/// How an increment of loading is brought to equilibrium.
class EquilibriumSearch {
 public:
  virtual ~EquilibriumSearch() = default;

  /// Its parameters, read from the table [solver].
  virtual void declare(class Parameters& parameters) = 0;
  /// Called once at set-up, after bodies have their masses.
  virtual void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) = 0;
  /// Whether it starts from the motion of an increment before; of a stage that begins, that of a small one.
  [[nodiscard]] virtual bool extrapolates() const = 0;

  /// Finds the equilibrium of a step of pseudo-time (s). False if it does not settle before the increment is exhausted.
  virtual bool find(Increment& increment, double step) = 0;
  /// The same in a live increment. False also if it knows no way to do so.
  virtual bool find_live(Increment& /*increment*/, double /*step*/) { return false; }
};

}  // namespace ligament
