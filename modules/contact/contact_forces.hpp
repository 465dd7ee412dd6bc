#pragma once

#include <algorithm>

#include "contact/contact_ends.hpp"
#include "contact/contact_springs.hpp"
#include "contact/contact_trial.hpp"
#include "contact/law_ranges.hpp"
#include "contact/pairings.hpp"
#include "core/block_sum.hpp"
#include "core/force_provider.hpp"

namespace ligament {

/// Forces of one kind of contact: kinematics → law → forces, block by block, so that the arrays between the three stay
/// in the first cache. A body adds up the forces of its contacts in their order, whether one thread brings them to the
/// bodies contact by contact, or many fetch them body by body.
template <class Pairing>
class ContactForces : public ForceProvider {
 public:
  void add_forces(const Model& model, State& state) override {
    if (is_shared(Pairing::table(state).size())) {
      add_forces_by_body(model, state);
    } else {
      add_forces_by_contact(model, state);
    }
  }

  void add_stiffness(const Model& model, const State& state, StiffnessBounds& bounds) const override {
    for (std::size_t row = 0; row < Pairing::table(state).size(); ++row) {
      Pairing::add_stiffness(model, state, row, Pairing::motion(model, state, row).geometry, bounds);
    }
  }

  void assemble(const Model& model, const State& state, StiffnessSum& stiffness) const override {
    assemble_contacts<Pairing>(model, state, stiffness);
  }

  void add_secants(const Model& /*model*/, const State& state, const ContactMemory& before,
                   std::vector<double>& stiffness) const override {
    const ContactTable& contacts = Pairing::table(state);
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      const ContactValues now = values_of(contacts, row);
      stiffness.push_back(normal_secant(now, Pairing::table(before), row));
      stiffness.push_back(shear_secant(now, Pairing::table(before), row));
    }
  }

  [[nodiscard]] std::size_t n_springs(const Model& /*model*/, const State& state) const override {
    return 2 * Pairing::table(state).size();
  }

  void add_loose_contacts(const State& state, const ContactMemory& before, std::size_t first_spring,
                          std::vector<LooseContact>& loose) const override {
    ligament::add_loose_contacts(Pairing::table(state), Pairing::table(before), first_spring, loose);
  }

  [[nodiscard]] SpringAnswer try_contact(const Model& model, const State& state, const ContactMemory& before,
                                         std::size_t spring, const SpringPair& stretch) const override {
    return ligament::try_contact(model, Pairing::table(state), Pairing::table(before), spring / 2, stretch);
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
  void add_forces_by_contact(const Model& model, State& state) const {
    const ContactTable& contacts = Pairing::table(state);
    if (contacts.size() == 0) return;
    BlockMotion motion;
    for (const LawBlock& block : law_blocks(model, contacts)) {
      measure_motion(model, state, block, motion);
      apply_law(model, Pairing::table(state), block, motion);
      visit_forces(contacts, block, motion, [&](std::size_t row, const auto& forces) {
        const auto bodies = Pairing::end_bodies(model, contacts, row);
        for (std::size_t end = 0; end < Pairing::n_ends; ++end) {
          if (Pairing::end_kinds[end] == BodyKind::particle) {
            add(forces[end], state.particles, bodies[end]);
          } else {
            add(forces[end], state.nodes, bodies[end]);
          }
        }
      });
    }
  }

  void add_forces_by_body(const Model& model, State& state) {
    const ContactTable& contacts = Pairing::table(state);
    ends_.update<Pairing>(model, contacts);
    end_forces_.resize(contacts.size());
    const std::vector<LawBlock> blocks = law_blocks(model, contacts);
    parallel_ranges(blocks.size(), true, [&](std::size_t begin, std::size_t end) {
      BlockMotion motion;
      for (std::size_t i = begin; i < end; ++i) {
        measure_motion(model, state, blocks[i], motion);
        apply_law(model, Pairing::table(state), blocks[i], motion);
        visit_forces(contacts, blocks[i], motion,
                     [&](std::size_t row, const auto& forces) { end_forces_[row] = forces; });
      }
    });
    fetch_forces(ends_.at_particles(), state.particles);
    fetch_forces(ends_.at_nodes(), state.nodes);
  }

  static void measure_motion(const Model& model, State& state, const LawBlock& block, BlockMotion& motion) {
    Pairing::measure(model, state, block, motion);
    ContactTable& contacts = Pairing::table(state);
    std::copy_n(motion.opening.begin(), block.size(), contacts.opening.begin() + block.begin);
    for (std::size_t i = 0; i < block.size(); ++i) {
      contacts.shear_displacement[block.begin + i] += motion.slip_increment[i];
    }
  }

  static void apply_law(const Model& model, ContactTable& contacts, const LawBlock& block, const BlockMotion& motion) {
    const auto history = history_pointers(model, contacts, block.law_row, block.begin);
    const auto part = [&](auto& field) { return std::span(field).subspan(block.begin, block.size()); };
    block.law->evaluate({part(contacts.opening), std::span(motion.slip_increment).first(block.size()),
                         part(contacts.normal_stiffness), part(contacts.shear_stiffness), part(contacts.area),
                         part(contacts.normal_force), part(contacts.shear_force), part(contacts.bond), history});
  }

  /// Calls take(row, forces on the ends) for every contact of a block.
  template <class Take>
  static void visit_forces(const ContactTable& contacts, const LawBlock& block, const BlockMotion& motion,
                           Take&& take) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t row = block.begin + i;
      const ContactGeometry geometry = motion.geometry(i);
      const Vector& normal = geometry.normal;
      const ShearVector shear = contacts.shear_force[row];
      const Vector force = contacts.normal_force[row] * normal + shear * tangent(normal);
      take(row, Pairing::end_forces(geometry, {force, shear}));
    }
  }

  static void add(const EndForce& end, ParticleState& particles, std::size_t row) {
    particles.translation.force[row] += end.force;
    particles.rotation.moment[row] += end.moment;
  }
  static void add(const EndForce& end, NodeState& nodes, std::size_t row) { nodes.translation.force[row] += end.force; }

  template <class Bodies>
  void fetch_forces(const Occurrences& ends, Bodies& bodies) const {
    if (ends.places.empty()) return;
    parallel_ranges(ends.begin.size() - 1, true, [&](std::size_t begin, std::size_t end) {
      for (std::size_t body = begin; body < end; ++body) {
        for (const std::size_t number : ends.of(body)) {
          add(end_forces_[number / Pairing::n_ends][number % Pairing::n_ends], bodies, body);
        }
      }
    });
  }

  // Scratch of threads that share a table.
  ContactEnds ends_;
  std::vector<std::array<EndForce, Pairing::n_ends>> end_forces_;
};

}  // namespace ligament
