#pragma once

#include "core/force_provider.hpp"

namespace ligament {

/// Weight of all bodies, m g with their real masses, whatever masses move them.
class Gravity : public ForceProvider {
 public:
  explicit Gravity(const Vector& acceleration) : acceleration_(acceleration) {}

  void add_forces(const Model& model, State& state) override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;

 private:
  Vector acceleration_;  ///< g (m/s2)
};

}  // namespace ligament
