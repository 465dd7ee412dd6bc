#include "contact/new_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/contact_stiffness.hpp"
#include "contact/cut_pairs.hpp"
#include "contact/facet_search.hpp"
#include "contact/pairings.hpp"
#include "core/error.hpp"

namespace ligament {
namespace {

SetupPair pair_at(const ContactTable& contacts, std::size_t row) { return {contacts.first[row], contacts.second[row]}; }

struct NewContact {
  const Material& material;
  Index bond_law = -1;
  bool is_setup = false;
  double rest_distance = 0.0;  ///< (m)
  double cut_gap = 0.0;        ///< of a notch between bodies of set-up (m)
  double free_distance = 0.0;  ///< at which bodies apart at set-up touch (m)
  double height = 0.0;         ///< H of Eq. (33) (m)
  double length = 0.0;         ///< L of Eq. (33) (m)
};

void fill(const Model& model, ContactTable& contacts, std::size_t row, const NewContact& contact) {
  contacts.rest_distance[row] = contact.rest_distance;
  contacts.initial_gap[row] = contact.is_setup ? contact.cut_gap : contact.rest_distance - contact.free_distance;
  const ContactStiffness stiffness =
      contact_stiffness(contact.material, model.plane, contact.height, contact.length, model.thickness);
  contacts.normal_stiffness[row] = stiffness.normal;
  contacts.shear_stiffness[row] = stiffness.shear;
  contacts.area[row] = stiffness.area;
  contacts.bond[row] = contacts.law[row] == contact.bond_law ? BondState::bonded : BondState::unbonded;
}

/// A contact is known to be near, not to have moved: its opening now also stands for the one before.
template <class Pairing>
void measure_opening(const Model& model, const State& state, ContactTable& contacts, std::size_t row) {
  contacts.opening[row] = contacts.initial_gap[row];
  contacts.opening[row] = Pairing::motion(model, state, row).opening;
}

/// A particle at an interface or wall.
struct InterfacePlace {
  double distance = 0.0;  ///< at rest (m)
  bool is_setup = false;
  double cut_gap = 0.0;
  const Wall* wall = nullptr;
};

PairLaws interface_laws(const Model& model, const SetupPair& pair, const Wall* wall) {
  if (wall != nullptr) return {wall->bond_law, wall->contact_law};
  const Material& material = interface_material(model, pair);
  return {material.bond_law, material.contact_law};
}

const Wall* wall_of_facet(const Model& model, const SetupPair& pair) {
  return model.wall_of_node(model.facets.nodes[pair.second][0]);
}

void check_distance(const Model& model, const SetupPair& pair, const InterfacePlace& place) {
  if (!place.is_setup || place.distance > 1e-6 * model.particles.radius[pair.first]) return;
  throw InputError(fmt::format(
      "the centre of particle {} lies on or behind {}", model.particles.id[pair.first],
      place.wall == nullptr ? "the boundary of the elements" : fmt::format("the wall '{}'", place.wall->name)));
}

void fill_interface_contact(const Model& model, ContactTable& contacts, std::size_t row, const InterfacePlace& place) {
  const SetupPair pair = pair_at(contacts, row);
  const double radius = model.particles.radius[pair.first];
  check_distance(model, pair, place);
  // choice: a length of less than a quarter of the radius would make the stiffness meaningless.
  const double length = std::max(place.is_setup ? place.distance : radius, 0.25 * radius);
  fill(model, contacts, row,
       {.material = interface_material(model, pair),
        .bond_law = interface_laws(model, pair, place.wall).bond,
        .is_setup = place.is_setup,
        .rest_distance = place.distance,
        .cut_gap = place.cut_gap,
        .free_distance = radius,
        .height = 2.0 * radius,
        .length = length});
}

}  // namespace

const Material& particle_contact_material(const Model& model, const SetupPair& pair) {
  return model.materials[std::min(model.particles.material[pair.first], model.particles.material[pair.second])];
}

const Material& interface_material(const Model& model, const SetupPair& pair) {
  return model.materials[model.zones[model.particles.zone[pair.first]].interface_material];
}

PairLaws particle_laws(const Model& model, const SetupPair& pair) {
  const Material& material = particle_contact_material(model, pair);
  return {material.bond_law, material.contact_law};
}

PairLaws facet_laws(const Model& model, const SetupPair& pair) {
  return interface_laws(model, pair, wall_of_facet(model, pair));
}

PairLaws corner_laws(const Model& model, const SetupPair& pair) {
  return interface_laws(model, pair, model.wall_of_node(pair.second));
}

bool is_setup_pair(const std::vector<SetupPair>& pairs, const SetupPair& pair) {
  return std::binary_search(pairs.begin(), pairs.end(), pair);
}

double particle_rest_distance(const Model& model, const SetupPair& pair) {
  return norm(model.particles.position[pair.second] - model.particles.position[pair.first]);
}

double facet_rest_distance(const Model& model, const SetupPair& pair) {
  const auto& [i, j] = model.facets.nodes[pair.second];
  return place_at_facet(model.nodes.position[i], model.nodes.position[j], model.particles.position[pair.first])
      .distance;
}

double corner_rest_distance(const Model& model, const SetupPair& pair) {
  return norm(model.nodes.position[pair.second] - model.particles.position[pair.first]);
}

void fill_particle_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row) {
  const SetupPair pair = pair_at(contacts, row);
  const ParticleData& particles = model.particles;
  const Material& material = particle_contact_material(model, pair);
  const bool is_setup = is_setup_pair(model.particle_pairs, pair);
  const double distance = particle_rest_distance(model, pair);
  const double radii = particles.radius[pair.first] + particles.radius[pair.second];
  const bool use_radii = material.contact_length == ContactLength::radius_sum || !is_setup;
  const double height = 2.0 * std::min(particles.radius[pair.first], particles.radius[pair.second]);
  fill(model, contacts, row,
       {.material = material,
        .bond_law = material.bond_law,
        .is_setup = is_setup,
        .rest_distance = distance,
        .cut_gap = particle_gap(model, pair),
        .free_distance = radii,
        .height = height,
        .length = use_radii ? radii : distance});
  measure_opening<ParticlePairing>(model, state, contacts, row);
}

void fill_facet_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row) {
  const SetupPair pair = pair_at(contacts, row);
  fill_interface_contact(model, contacts, row,
                         {facet_rest_distance(model, pair), is_setup_pair(model.facet_pairs, pair),
                          facet_gap(model, pair), wall_of_facet(model, pair)});
  measure_opening<FacetPairing>(model, state, contacts, row);
}

void fill_corner_contact(const Model& model, const State& state, ContactTable& contacts, std::size_t row) {
  const SetupPair pair = pair_at(contacts, row);
  fill_interface_contact(model, contacts, row,
                         {corner_rest_distance(model, pair), is_setup_pair(model.corner_pairs, pair),
                          corner_gap(model, pair), model.wall_of_node(pair.second)});
  measure_opening<CornerPairing>(model, state, contacts, row);
}

}  // namespace ligament
