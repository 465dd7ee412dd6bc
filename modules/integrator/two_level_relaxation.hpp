#pragma once

#include <optional>

#include "core/integrator.hpp"
#include "integrator/adaptive_momenta.hpp"
#include "integrator/two_level_mass.hpp"

namespace ligament {

/// Dynamic relaxation with masses of two levels, by which slow motions of the structure relax as fast as the others.
/// The momenta p of the free freedoms are stepped,
///   p(n+½) = [(2 - c) p(n-½) + 2 f] / (2 + c),   v(n+½) = M⁻¹ p(n+½),   u(n+1) = u(n) + v(n+½),
/// in steps of 1 s of pseudo-time, with c = 2 ω from the motion itself. The energy identity of central differences
/// holds with K(n) = ½ v(n-½)·p(n+½).
class TwoLevelRelaxation : public Integrator {
 public:
  void declare(Parameters& parameters) override;
  [[nodiscard]] bool needs_stiffness() const override { return true; }
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) override;

  StepTravel update_positions(const Model& model, State& state) const override;
  void update_velocities(const Model& model, State& state) override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
  void book_work(const Model& model, State& state) override;

 private:
  DampingBounds bounds_;
  std::optional<double> coarse_cell_;  ///< (m)
  std::optional<TwoLevelMass> mass_;
  std::vector<double> drag_;  ///< impulse of damping in the step under way, p(n+½) - p(n-½) - f
};

}  // namespace ligament
