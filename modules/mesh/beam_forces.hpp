#pragma once

#include "core/force_provider.hpp"

namespace ligament {

/// Internal forces and moments of beam elements.
class BeamForces : public ForceProvider {
 public:
  void add_forces(const Model& model, State& state) override;
  void add_stiffness(const Model& model, const State& state, StiffnessBounds& bounds) const override;
  void assemble(const Model& model, const State& state, StiffnessSum& stiffness) const override;
  [[nodiscard]] std::size_t n_springs(const Model& model, const State& /*state*/) const override {
    return 3 * model.beam_elements.size();
  }
  void add_secants(const Model& model, const State& state, const ContactMemory& before,
                   std::vector<double>& stiffness) const override;
  [[nodiscard]] ForceMagnitudes internal_forces(const Model& model, const State& state) const override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
};

}  // namespace ligament
