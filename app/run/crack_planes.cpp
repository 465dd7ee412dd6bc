#include "run/crack_planes.hpp"

#include <algorithm>

#include "contact/dropped_contacts.hpp"
#include "contact/law_ranges.hpp"

namespace ligament {
namespace {

template <class Pairing>
void add_softening(const Model& model, const State& state, std::vector<CrackPlane>& planes) {
  const Field<BondState>& bond = Pairing::table(state).bond;
  for (std::size_t row = 0; row < bond.size(); ++row) {
    if (bond[row] == BondState::softening) planes.push_back(crack_plane<Pairing>(model, state, row));
  }
}

}  // namespace

ContactReading read_contact(const Model& model, const ContactTable& contacts, std::size_t row) {
  const Index law = contacts.law[row];
  std::vector<double> history;
  for (const double* value : history_pointers(model, contacts, law, row)) history.push_back(*value);
  const ContactEnergies energies = contact_energies(model, contacts, row);
  ContactReading reading{model.laws[law].law->damage(history), energies.spent()};
  if (contacts.bond[row] == BondState::broken) {
    reading.damage.value = 1.0;
    if (reading.damage.mode == FractureMode::none) {
      // A law that tells of no damage tells by its energies how its bonds broke.
      reading.damage.mode =
          energies.fracture_shear > energies.fracture_tension ? FractureMode::shear : FractureMode::tension;
    }
  }
  return reading;
}

Field<double> particle_damage(const Model& model, const State& state) {
  Field<double> damage(model.particles.size(), 0.0);
  const auto raise = [&](Index particle, double value) { damage[particle] = std::max(damage[particle], value); };
  const auto see = [&](const ContactTable& contacts, bool are_particles) {
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      const double value = read_contact(model, contacts, row).damage.value;
      raise(contacts.first[row], value);
      if (are_particles) raise(contacts.second[row], value);
    }
  };
  see(state.particle_contacts, true);
  see(state.facet_contacts, false);
  see(state.corner_contacts, false);
  return damage;
}

std::vector<CrackPlane> softening_planes(const Model& model, const State& state) {
  std::vector<CrackPlane> planes;
  add_softening<ParticlePairing>(model, state, planes);
  add_softening<FacetPairing>(model, state, planes);
  add_softening<CornerPairing>(model, state, planes);
  return planes;
}

}  // namespace ligament
