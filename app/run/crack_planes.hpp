#pragma once

#include <vector>

#include "contact/pairings.hpp"
#include "core/constitutive_law.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// What a contact has suffered: damage (1 if its bond is broken, whatever its law says) and the energy that it has
/// spent so far, friction included (J).
struct ContactReading {
  ContactDamage damage;
  double spent_energy = 0.0;
};
ContactReading read_contact(const Model& model, const ContactTable& contacts, std::size_t row);

/// The plane of a damaged contact: where a crack runs, or begins to.
struct CrackPlane {
  Vector centre;        ///< contact point (m)
  Vector normal;        ///< unit normal of the plane
  double length = 0.0;  ///< H (m)
  double damage = 0.0;
  FractureMode mode = FractureMode::none;
  double spent_energy = 0.0;  ///< (J)

  /// Its two ends (m).
  [[nodiscard]] std::array<Vector, 2> ends() const {
    const Vector half = 0.5 * length * tangent(normal);
    return {centre - half, centre + half};
  }
};

/// Where a contact acts at present (m).
template <class Pairing>
Vector contact_point(const Model& model, const State& state, const ContactGeometry& geometry, std::size_t row) {
  const Index particle = Pairing::table(state).first[row];
  return model.particles.position[particle] + state.particles.translation.displacement[particle] +
         geometry.arm_first * geometry.normal;
}

/// The plane of a contact where its bodies are at present.
template <class Pairing>
CrackPlane crack_plane(const Model& model, const State& state, std::size_t row) {
  const ContactTable& contacts = Pairing::table(state);
  const ContactGeometry geometry = Pairing::motion(model, state, row).geometry;
  const ContactReading reading = read_contact(model, contacts, row);
  return {.centre = contact_point<Pairing>(model, state, geometry, row),
          .normal = geometry.normal,
          .length = contacts.area[row] / model.thickness,
          .damage = reading.damage.value,
          .mode = reading.damage.mode,
          .spent_energy = reading.spent_energy};
}

/// Of each particle, the largest damage of its contacts.
Field<double> particle_damage(const Model& model, const State& state);

/// The planes of all bonds that soften.
std::vector<CrackPlane> softening_planes(const Model& model, const State& state);

}  // namespace ligament
