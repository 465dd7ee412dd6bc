#pragma once

#include "contact/law_ranges.hpp"
#include "contact/pairings.hpp"
#include "core/force_provider.hpp"

namespace ligament {

/// Forces of one kind of contact: kinematics → law → forces, block by block, so that the arrays between the three stay
/// in the first cache.
template <class Pairing>
class ContactForces : public ForceProvider {
 public:
  void add_forces(const Model& model, State& state) override {
    visit_law_blocks(model, Pairing::table(state), [&](const LawBlock& block) {
      measure_motion(model, state, block);
      apply_law(model, Pairing::table(state), block);
      apply_forces(model, state, block);
    });
  }

  void add_stiffness(const Model& model, const State& state, StiffnessBounds& bounds) const override {
    for (std::size_t row = 0; row < Pairing::table(state).size(); ++row) {
      Pairing::add_stiffness(model, state, row, Pairing::motion(model, state, row).geometry, bounds);
    }
  }

  [[nodiscard]] ForceMagnitudes internal_forces(const Model& /*model*/, const State& state) const override {
    const ContactTable& contacts = Pairing::table(state);
    return block_sum(contacts.size(), [&](std::size_t row) {
      const double force = std::sqrt(contacts.normal_force[row] * contacts.normal_force[row] +
                                     contacts.shear_force[row] * contacts.shear_force[row]);
      return ForceMagnitudes{force, force > 0.0 ? 1.0 : 0.0};
    });
  }

  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override {
    const ContactEnergies energies = table_energies(model, Pairing::table(state));
    return {{std::string("elastic_") + Pairing::name, EnergyKind::elastic, energies.stored()},
            {"fracture_tension", EnergyKind::dissipated, energies.fracture_tension},
            {"fracture_shear", EnergyKind::dissipated, energies.fracture_shear},
            {"friction", EnergyKind::dissipated, energies.friction}};
  }

 private:
  void measure_motion(const Model& model, State& state, const LawBlock& block) {
    ContactTable& contacts = Pairing::table(state);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t row = block.begin + i;
      const ContactMotion motion = Pairing::motion(model, state, row);
      geometry_[i] = motion.geometry;
      slip_increment_[i] = motion.slip_increment;
      contacts.opening[row] = motion.opening;
      contacts.shear_displacement[row] += motion.slip_increment;
    }
  }

  void apply_law(const Model& model, ContactTable& contacts, const LawBlock& block) {
    const auto history = history_pointers(model, contacts, block.law_row, block.begin);
    const auto part = [&](auto& field) { return std::span(field).subspan(block.begin, block.size()); };
    block.law->evaluate({part(contacts.opening), std::span(slip_increment_).first(block.size()),
                         part(contacts.normal_stiffness), part(contacts.shear_stiffness), part(contacts.area),
                         part(contacts.normal_force), part(contacts.shear_force), part(contacts.bond), history});
  }

  void apply_forces(const Model& model, State& state, const LawBlock& block) {
    const ContactTable& contacts = Pairing::table(state);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t row = block.begin + i;
      const Vector& normal = geometry_[i].normal;
      const ShearVector shear = contacts.shear_force[row];
      const Vector force = contacts.normal_force[row] * normal + shear * tangent(normal);
      Pairing::apply(model, state, row, geometry_[i], {force, shear});
    }
  }

  // Scratch of one block.
  std::array<ContactGeometry, block_size> geometry_;
  std::array<ShearVector, block_size> slip_increment_;
};

}  // namespace ligament
