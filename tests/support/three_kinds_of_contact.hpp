#pragma once

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "support/hand_made_model.hpp"
#include "support/moved_bodies.hpp"
#include "support/resting_state.hpp"

namespace ligament::support {

/// A square of elements' outline, one disc on its right facet, one at a corner of it, one bonded to the first: a
/// contact of each kind, with 10 % overlap.
struct ThreeKindsOfContact {
  static constexpr double radius = 0.1;
  Model model = empty_model();
  State state;

  explicit ThreeKindsOfContact(const Vector& origin = {}) {
    add_outline(model, {origin, origin + Vector{1.0, 0.0}, origin + Vector{1.0, 1.0}, origin + Vector{0.0, 1.0}});
    add_particle(model, origin + Vector{1.09, 0.3}, radius);
    add_particle(model, origin + Vector{1.2, 0.42}, 0.8 * radius);
    add_particle(model, origin + Vector{1.06, 1.07}, radius);
    state = resting_state(model);
    GridContactDetector(1e-9).bond(model, state);
  }

  void add_forces() {
    clear_forces(state);
    ContactForces<ParticlePairing>().add_forces(model, state);
    ContactForces<FacetPairing>().add_forces(model, state);
    ContactForces<CornerPairing>().add_forces(model, state);
  }

  [[nodiscard]] std::array<const ContactTable*, 3> tables() const {
    return {&state.particle_contacts, &state.facet_contacts, &state.corner_contacts};
  }
};

}  // namespace ligament::support
