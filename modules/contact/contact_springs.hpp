#pragma once

#include "contact/pairings.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {

/// How a unit of each freedom opens or shears a contact; `point_force` is the force on the second body that would do
/// the work: what the ends of the contact feel of a force is how they move it.
template <class Pairing>
std::vector<SpringTerm> contact_spring(const FreedomNumbers& numbers, const Model& model, const ContactTable& contacts,
                                       std::size_t row, const ContactGeometry& geometry,
                                       const ContactPointForce& point_force) {
  std::vector<SpringTerm> terms;
  const auto bodies = Pairing::end_bodies(model, contacts, row);
  const auto forces = Pairing::end_forces(geometry, point_force);
  for (std::size_t end = 0; end < Pairing::n_ends; ++end) {
    const bool is_particle = Pairing::end_kinds[end] == BodyKind::particle;
    for (int axis = 0; axis < dimension; ++axis) {
      const Index freedom = is_particle ? numbers.particle(bodies[end], axis) : numbers.node(bodies[end], axis);
      terms.push_back({freedom, component(forces[end].force, axis)});
    }
    if (is_particle) terms.push_back({numbers.rotation(bodies[end]), forces[end].moment});
  }
  return terms;
}

/// Eq. (29), as two springs each; without stiffness where a contact neither touches nor holds.
template <class Pairing>
void assemble_contacts(const Model& model, const State& state, StiffnessSum& stiffness) {
  const ContactTable& contacts = Pairing::table(state);
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    const bool is_bonded = contacts.bond[row] == BondState::bonded || contacts.bond[row] == BondState::softening;
    const double share = is_bonded || contacts.opening[row] <= 0.0 ? 1.0 : 0.0;
    const ContactGeometry geometry = Pairing::motion(model, state, row).geometry;
    const Vector& normal = geometry.normal;
    const auto spring = [&](const ContactPointForce& force) {
      return contact_spring<Pairing>(stiffness.numbers(), model, contacts, row, geometry, force);
    };
    stiffness.add_spring(spring({normal, 0.0}), share * contacts.normal_stiffness[row]);
    stiffness.add_spring(spring({tangent(normal), 1.0}), share * contacts.shear_stiffness[row]);
  }
}

}  // namespace ligament
