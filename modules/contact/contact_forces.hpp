#pragma once

#include <algorithm>

#include "contact/contact_secants.hpp"
#include "contact/contact_springs.hpp"
#include "contact/contact_trial.hpp"
#include "contact/law_ranges.hpp"
#include "contact/pairings.hpp"
#include "contact/shared_bodies.hpp"
#include "core/block_sum.hpp"
#include "core/force_provider.hpp"

namespace ligament {

/// Forces of one kind of contact: kinematics → law → forces, block by block, so that the arrays between the stages stay
/// in the first cache. A body adds up the forces of its contacts in their order, whatever the number of threads.
template <class Pairing>
class ContactForces : public ForceProvider {
 public:
  void add_forces(const Model& model, State& state) override {
    for (std::size_t law = 0; law < model.laws.size(); ++law) add_forces_of_law(model, state, law);
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
  /// What blocks pass from stage to stage and to the next block, and forces that have to wait for those of other
  /// threads.
  struct Part {
    BlockMotion motion;
    BlockEndForces<Pairing::n_ends> end_forces;
    std::vector<double*> history;  ///< of the law, from the block on
    std::vector<WaitingForce> waiting;
  };

  /// Each thread takes a part of the contacts. A force on a body that contacts of earlier parts may act on as well
  /// waits until all parts are done: in spatial order those are the bodies on a line.
  void add_forces_of_law(const Model& model, State& state, std::size_t law) {
    const auto first = static_cast<std::size_t>(Pairing::table(state).law_begin[law]);
    const auto count = static_cast<std::size_t>(Pairing::table(state).law_begin[law + 1]) - first;
    const std::size_t n_parts = is_shared(count) ? static_cast<std::size_t>(threads().count) : 1;
    parts_.resize(std::max(parts_.size(), n_parts));
    parallel_ranges(n_parts, n_parts > 1, [&](std::size_t part, std::size_t /*end*/) {
      const LawBlock rows{model.laws[law].law.get(), static_cast<Index>(law), first + count * part / n_parts,
                          first + count * (part + 1) / n_parts};
      const TouchedBodies before = touched_bodies<Pairing>(model, Pairing::table(state), first, rows.begin);
      add_forces_of_part(model, state, rows, before, parts_[part]);
    });
    for (std::size_t part = 1; part < n_parts; ++part) {
      for (const WaitingForce& waiting : parts_[part].waiting) add(waiting.force, state, waiting.kind, waiting.body);
    }
  }

  static void add_forces_of_part(const Model& model, State& state, const LawBlock& rows, const TouchedBodies& before,
                                 Part& part) {
    part.waiting.clear();
    part.history = history_pointers(model, Pairing::table(state), rows.law_row, rows.begin);
    for (std::size_t begin = rows.begin; begin < rows.end; begin += contact_block_size) {
      const LawBlock block{rows.law, rows.law_row, begin, std::min(begin + contact_block_size, rows.end)};
      measure_motion(model, state, block, part.motion);
      apply_law(Pairing::table(state), block, part);
      Pairing::find_end_forces(Pairing::table(state), block, part.motion, part.end_forces);
      if (has_shared_bodies(model, Pairing::table(state), block, before)) {
        bring_or_keep_forces(model, state, block, before, part);
      } else {
        bring_forces(model, state, block, part.end_forces);
      }
    }
  }

  /// Whether contacts of a block act on bodies that contacts before this part may act on as well.
  static bool has_shared_bodies(const Model& model, const ContactTable& contacts, const LawBlock& block,
                                const TouchedBodies& before) {
    if (before.is_empty()) return false;
    if constexpr (Pairing::are_ordered) return before.may_include(Pairing::end_kinds[0], contacts.first[block.begin]);
    for (std::size_t row = block.begin; row < block.end; ++row) {
      const auto bodies = Pairing::end_bodies(model, contacts, row);
      for (std::size_t end = 0; end < Pairing::n_ends; ++end) {
        if (before.may_include(Pairing::end_kinds[end], bodies[end])) return true;
      }
    }
    return false;
  }

  /// Brings the forces of a block to the bodies, or keeps those that have to wait.
  static void bring_or_keep_forces(const Model& model, State& state, const LawBlock& block, const TouchedBodies& before,
                                   Part& part) {
    const ContactTable& contacts = Pairing::table(state);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto bodies = Pairing::end_bodies(model, contacts, block.begin + i);
      for (std::size_t end = 0; end < Pairing::n_ends; ++end) {
        const BodyKind kind = Pairing::end_kinds[end];
        if (before.may_include(kind, bodies[end])) {
          part.waiting.push_back({kind, bodies[end], part.end_forces.at(end, i)});
        } else {
          add(part.end_forces.at(end, i), state, kind, bodies[end]);
        }
      }
    }
  }

  /// Brings the forces of a block to the bodies. Contacts of one first body follow each other: it is fetched once for
  /// all of them, which do not have to wait for each other then. No other end of them is at that body.
  static void bring_forces(const Model& model, State& state, const LawBlock& block,
                           const BlockEndForces<Pairing::n_ends>& forces) {
    const ContactTable& contacts = Pairing::table(state);
    const Index* first_bodies = &contacts.first[block.begin];
    const std::size_t size = block.size();
    for (std::size_t i = 0; i < size;) {
      const Index first = first_bodies[i];
      EndForce sum = force_on(state, Pairing::end_kinds[0], first);
      do {
        sum += forces.at(0, i);
        const auto bodies = Pairing::end_bodies(model, contacts, block.begin + i);
        for (std::size_t end = 1; end < Pairing::n_ends; ++end) {
          add(forces.at(end, i), state, Pairing::end_kinds[end], bodies[end]);
        }
      } while (++i < size && first_bodies[i] == first);
      set_force_on(state, Pairing::end_kinds[0], first, sum);
    }
  }

  static void measure_motion(const Model& model, State& state, const LawBlock& block, BlockMotion& motion) {
    Pairing::measure(model, state, block, motion);
    ContactTable& contacts = Pairing::table(state);
    keep_motion(block.size(), motion, &contacts.opening[block.begin], &contacts.shear_displacement[block.begin]);
  }

  static void apply_law(ContactTable& contacts, const LawBlock& block, Part& part) {
    const auto rows = [&](auto& field) { return std::span(field).subspan(block.begin, block.size()); };
    block.law->evaluate({rows(contacts.opening), std::span(part.motion.slip_increment).first(block.size()),
                         rows(contacts.normal_stiffness), rows(contacts.shear_stiffness), rows(contacts.area),
                         rows(contacts.normal_force), rows(contacts.shear_force), rows(contacts.bond), part.history});
    for (double*& column : part.history) column += block.size();
  }

  static void add(const EndForce& force, State& state, BodyKind kind, Index body) {
    EndForce sum = force_on(state, kind, body);
    sum += force;
    set_force_on(state, kind, body, sum);
  }

  std::vector<Part> parts_;
};

}  // namespace ligament
