#pragma once

#include "core/contact_detector.hpp"

namespace ligament {

/// Contact detection by cell grids, with lists that are kept until a body has moved by half a skin.
class GridContactDetector : public ContactDetector {
 public:
  /// skin (m): pairs without bond are listed while their gap is below it.
  explicit GridContactDetector(double skin) : skin_(skin) {}

  void bond(Model& model, State& state) override;
  bool update(const Model& model, State& state) override;
  [[nodiscard]] double spare_travel(const Model& model, const State& state) const override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;

 private:
  /// How far a body may go from where it was at the last update (m): two may approach each other from both sides.
  [[nodiscard]] double reach() const { return 0.5 * skin_; }
  void rebuild_particle_contacts(const Model& model, State& state, bool is_setup) const;
  void rebuild_interface_contacts(const Model& model, State& state, bool is_setup) const;

  double skin_;
};

}  // namespace ligament
