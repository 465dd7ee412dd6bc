#include "contact/seats.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/contact_rows.hpp"
#include "contact/contact_stiffness.hpp"
#include "contact/facet_search.hpp"

namespace ligament {
namespace {

/// What a node holds of the edges of elements along a line.
struct HeldEdge {
  double length = 0.0;  ///< (m)
  Index element = -1;
};

/// Nodes of elements on a wall, in their order.
std::map<Index, HeldEdge> nodes_on(const Model& model, std::size_t wall) {
  const auto& [from, to] = model.wall_nodes(wall);
  const auto place_of = [&, first = from, second = to](Index node) {
    return place_at_facet(model.nodes.position[first], model.nodes.position[second], model.nodes.position[node]);
  };
  const double tolerance = 1e-6 * place_of(to).length;
  std::map<Index, HeldEdge> held;
  for (std::size_t facet = 0; facet < model.n_element_facets(); ++facet) {
    const auto& nodes = model.facets.nodes[facet];
    const bool is_on_line = std::all_of(nodes.begin(), nodes.end(),
                                        [&](Index node) { return std::abs(place_of(node).distance) <= tolerance; });
    if (!is_on_line) continue;
    for (const Index node : nodes) {
      const FacetPlace place = place_of(node);
      if (place.position < -tolerance || place.position > place.length + tolerance) continue;
      HeldEdge& edge = held[node];
      edge.length += 0.5 * norm(model.nodes.position[nodes[1]] - model.nodes.position[nodes[0]]);
      edge.element = model.facets.element[facet];
    }
  }
  return held;
}

void fill(const Model& model, const HeldEdge& edge, bool is_tied, ContactTable& contacts, std::size_t row) {
  Material material = model.materials[model.elements.material[edge.element]];
  material.stiffness = StiffnessFormula::plane;
  const ContactStiffness stiffness =
      contact_stiffness(material, model.plane, edge.length, 0.5 * edge.length, model.thickness);
  contacts.normal_stiffness[row] = stiffness.normal;
  contacts.shear_stiffness[row] = stiffness.shear;
  contacts.area[row] = stiffness.area;
  contacts.bond[row] = is_tied ? BondState::bonded : BondState::unbonded;
}

}  // namespace

void make_seats(const Model& model, State& state) {
  std::map<SetupPair, HeldEdge> seats;
  std::vector<ContactCandidate> candidates;
  for (std::size_t wall = 0; wall < model.walls.size(); ++wall) {
    const Wall& data = model.walls[wall];
    const auto facet = static_cast<Index>(model.n_element_facets() + wall);
    for (const auto& [node, edge] : nodes_on(model, wall)) {
      seats.emplace(SetupPair{node, facet}, edge);
      candidates.push_back({data.bond_law >= 0 ? data.bond_law : data.contact_law, node, facet, -1});
    }
  }
  ContactTable& contacts = state.seat_contacts;
  contacts = {};
  for (const std::size_t row : rebuild_rows(model, contacts, std::move(candidates))) {
    const SetupPair pair{contacts.first[row], contacts.second[row]};
    const bool is_tied = contacts.law[row] == model.walls[pair.second - model.n_element_facets()].bond_law;
    fill(model, seats.at(pair), is_tied, contacts, row);
  }
}

}  // namespace ligament
