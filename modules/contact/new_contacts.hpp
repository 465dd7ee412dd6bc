#pragma once

#include <span>

#include "core/model.hpp"
#include "core/state.hpp"

/// What a contact is born with: reference, springs, law.
namespace ligament {

/// The material that two particles share, or the one declared first if they differ.
const Material& particle_contact_material(const Model& model, const SetupPair& pair);
/// The material of the interface of a particle's zone.
const Material& interface_material(const Model& model, const SetupPair& pair);

/// Rows of Model::laws for pairs bonded at set-up and for all others.
struct PairLaws {
  Index bond = -1;
  Index contact = -1;
};
PairLaws particle_laws(const Model& model, const SetupPair& pair);
/// Those of the interface, or of the wall.
PairLaws facet_laws(const Model& model, const SetupPair& pair);
PairLaws corner_laws(const Model& model, const SetupPair& pair);

/// Whether pairs keep their rest distance as reference: those of set-up do.
bool is_setup_pair(const std::vector<SetupPair>& pairs, const SetupPair& pair);

/// Distance of the bodies of a pair at rest (m).
double particle_rest_distance(const Model& model, const SetupPair& pair);
double facet_rest_distance(const Model& model, const SetupPair& pair);
double corner_rest_distance(const Model& model, const SetupPair& pair);

/// Fill new rows whose law, first and second are set. Bonded are those under the bond law of their pair. Throw
/// InputError if a centre lies on the facet or node it is to be joined to, or behind it.
void fill_particle_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row);
void fill_facet_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row);
void fill_corner_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row);

}  // namespace ligament
