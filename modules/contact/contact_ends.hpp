#pragma once

#include "contact/pairings.hpp"
#include "core/occurrences.hpp"

namespace ligament {

/// The ends of contacts at each body, in the order of the contacts; end e of row r has the number r · n_ends + e. They
/// follow from table and model, so they are no part of the state, and are found anew when the table has changed.
class ContactEnds {
 public:
  template <class Pairing>
  void update(const Model& model, const ContactTable& contacts) {
    const bool is_known = first_ == contacts.first && second_ == contacts.second &&
                          particles_.begin.size() == model.particles.size() + 1 &&
                          nodes_.begin.size() == model.nodes.size() + 1;
    if (is_known) return;
    first_ = contacts.first;
    second_ = contacts.second;
    particles_ = find_occurrences(bodies<Pairing>(model, contacts, BodyKind::particle), model.particles.size());
    nodes_ = find_occurrences(bodies<Pairing>(model, contacts, BodyKind::node), model.nodes.size());
  }

  [[nodiscard]] const Occurrences& at_particles() const { return particles_; }
  [[nodiscard]] const Occurrences& at_nodes() const { return nodes_; }

 private:
  /// The bodies at all ends; -1 where they are of the other kind.
  template <class Pairing>
  static Field<Index> bodies(const Model& model, const ContactTable& contacts, BodyKind kind) {
    Field<Index> all;
    all.reserve(contacts.size() * Pairing::n_ends);
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      const auto ends = Pairing::end_bodies(model, contacts, row);
      for (std::size_t end = 0; end < Pairing::n_ends; ++end) {
        all.push_back(Pairing::end_kinds[end] == kind ? ends[end] : -1);
      }
    }
    return all;
  }

  Field<Index> first_;
  Field<Index> second_;
  Occurrences particles_;
  Occurrences nodes_;
};

}  // namespace ligament
