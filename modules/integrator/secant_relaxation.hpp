#pragma once

#include <optional>

#include "integrator/equilibrium_search.hpp"
#include "integrator/sparse_stiffness.hpp"

namespace ligament {

/// Direct secant relaxation: u ← u + K⁻¹ r with the resultants r of free bodies, K of elements and of contacts with the
/// stiffness with which they carry their forces. Under the control of a gauge the pseudo-time is unknown as well:
/// u ← u + K⁻¹ r + Δt d, d the answer to what a unit of time prescribes and loads, Δt from the gauge. With secants that
/// only fall while bonds soften, each iteration lowers the energy of a stable structure, so that no step is searched
/// for.
class SecantRelaxation : public EquilibriumSearch {
 public:
  void declare(Parameters& parameters) override;
  void use_stiffness(const Model& /*model*/, const State& /*state*/, const StiffnessSum& /*stiffness*/) override {}
  [[nodiscard]] bool extrapolates() const override { return false; }
  [[nodiscard]] bool follows_gauges() const override { return true; }
  bool find(Increment& increment, const IncrementTarget& target) override;

 private:
  /// Makes K, and d for this time (s) in units of it.
  void factorise(Increment& increment, std::vector<double> secants, double time);
  /// Whether contacts have changed so much since K was made that another one pays.
  [[nodiscard]] bool is_outdated(const std::vector<double>& secants) const;
  /// K⁻¹ r.
  [[nodiscard]] std::vector<double> correction(Increment& increment);

  std::int64_t keep_factors_ = 3;  ///< iterations

  // Scratch of an increment.
  std::optional<StiffnessSum> sum_;
  SparseStiffness matrix_;
  std::vector<double> secants_;    ///< in K
  std::vector<double> direction_;  ///< d
  std::int64_t n_uses_ = 0;        ///< of the factors
};

}  // namespace ligament
