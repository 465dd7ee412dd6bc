#pragma once

#include <algorithm>

#include "contact/pairings.hpp"

namespace ligament {

/// Bodies that some contacts act on: none beyond these rows.
struct TouchedBodies {
  Index particle_end = 0;
  Index node_end = 0;

  [[nodiscard]] bool is_empty() const { return particle_end == 0 && node_end == 0; }
  [[nodiscard]] bool may_include(BodyKind kind, Index body) const {
    return body < (kind == BodyKind::particle ? particle_end : node_end);
  }
};

/// Largest of these rows, -1 if there are none.
Index largest_row(const Index* rows, std::size_t count);

/// Those of the contacts in rows [begin, end) of a table.
template <class Pairing>
TouchedBodies touched_bodies(const Model& model, const ContactTable& contacts, std::size_t begin, std::size_t end) {
  // Of two particles the second is that with the larger row.
  if constexpr (Pairing::are_ordered) return {largest_row(contacts.second.data() + begin, end - begin) + 1, 0};
  TouchedBodies touched;
  for (std::size_t row = begin; row < end; ++row) {
    const auto bodies = Pairing::end_bodies(model, contacts, row);
    for (std::size_t k = 0; k < Pairing::n_ends; ++k) {
      Index& of_kind = Pairing::end_kinds[k] == BodyKind::particle ? touched.particle_end : touched.node_end;
      of_kind = std::max(of_kind, bodies[k] + 1);
    }
  }
  return touched;
}

/// The force on a body so far.
inline EndForce force_on(const State& state, BodyKind kind, Index body) {
  if (kind == BodyKind::node) return {state.nodes.translation.force[body], 0.0};
  return {state.particles.translation.force[body], state.particles.rotation.moment[body]};
}
inline void set_force_on(State& state, BodyKind kind, Index body, const EndForce& sum) {
  if (kind == BodyKind::node) {
    state.nodes.translation.force[body] = sum.force;
  } else {
    state.particles.translation.force[body] = sum.force;
    state.particles.rotation.moment[body] = sum.moment;
  }
}

/// A force on a body that contacts before this one, in other hands, may act on as well.
struct WaitingForce {
  BodyKind kind = BodyKind::particle;
  Index body = 0;
  EndForce force;
};

}  // namespace ligament
