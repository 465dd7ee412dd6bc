#pragma once

#include <optional>

#include "core/integrator.hpp"
#include "integrator/coarse_space.hpp"

namespace ligament {

/// Dynamic relaxation with masses of two levels: those scaled body by body, and those of coarse motions of the whole
/// structure, M⁻¹ = a (D⁻¹ + Z K_c⁻¹ Zᵀ). Slow motions get masses that fit them, and relax as fast as the others. The
/// momenta p of the free freedoms are stepped,
///   p(n+½) = [(2 - c) p(n-½) + 2 f] / (2 + c),   v(n+½) = M⁻¹ p(n+½),   u(n+1) = u(n) + v(n+½),
/// in steps of 1 s of pseudo-time, with c = 2 ω from the motion itself, ω² = -v·Δf / v·p. The energy identity of
/// central differences holds with K(n) = ½ v(n-½)·p(n+½).
class TwoLevelRelaxation : public Integrator {
 public:
  void declare(Parameters& parameters) override;
  [[nodiscard]] bool needs_stiffness() const override { return true; }
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) override;

  void update_positions(const Model& model, State& state) const override;
  void update_velocities(const Model& model, State& state) override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
  void book_work(const Model& model, State& state) override;

 private:
  [[nodiscard]] std::vector<double> answer(const std::vector<double>& momenta);
  [[nodiscard]] double damping_of(const std::vector<double>& velocities, const std::vector<double>& forces,
                                  const RelaxationState& memory) const;

  /// Floor of c: without it single assemblies fail to settle.
  double smallest_damping_ = 0.02;
  double largest_damping_ = 1.9;
  std::optional<double> coarse_cell_;  ///< (m)

  std::optional<CoarseSpace> coarse_;
  std::vector<double> inverse_mass_;  ///< a / D of free freedoms, 0 of the others
  double scale_ = 1.0;                ///< a
  std::vector<double> impulses_;      ///< p(n+½) - p(n-½) - f of the step under way
};

}  // namespace ligament
