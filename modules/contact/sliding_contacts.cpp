#include "contact/sliding_contacts.hpp"

#include <algorithm>

#include "contact/dropped_contacts.hpp"
#include "contact/facet_search.hpp"
#include "contact/law_ranges.hpp"
#include "contact/new_contacts.hpp"
#include "contact/pairings.hpp"

namespace ligament {
namespace {

/// Nodes of a facet, or the node of a corner.
std::vector<Index> nodes_of(const Model& model, Index second, bool is_facet) {
  if (!is_facet) return {second};
  return {model.facets.nodes[second].begin(), model.facets.nodes[second].end()};
}

bool meet(const std::vector<Index>& a, const std::vector<Index>& b) {
  return std::any_of(a.begin(), a.end(), [&](Index node) { return std::find(b.begin(), b.end(), node) != b.end(); });
}

/// Whether a particle no longer projects into the facet of a row; corners have no inside.
bool is_past_end(const Model& model, const State& state, const ContactTable& contacts, std::size_t row) {
  if (&contacts == &state.corner_contacts) return true;
  const auto place = [](const Field<Vector>& rest, const TranslationState& bodies, Index i) {
    return rest[i] + bodies.displacement[i];
  };
  const auto& [i, j] = model.facets.nodes[contacts.second[row]];
  return !place_at_facet(place(model.nodes.position, state.nodes.translation, i),
                         place(model.nodes.position, state.nodes.translation, j),
                         place(model.particles.position, state.particles.translation, contacts.first[row]))
              .projects_inside();
}

}  // namespace

std::vector<SetupPair> barred_by_bonds(const Model& model, const State& state, const std::vector<SetupPair>& found,
                                       bool are_facets) {
  std::vector<SetupPair> barred;
  for (const ContactTable* contacts : {&state.facet_contacts, &state.corner_contacts}) {
    const bool is_facet_table = contacts == &state.facet_contacts;
    for (std::size_t row = 0; row < contacts->size(); ++row) {
      const bool holds = contacts->bond[row] == BondState::bonded || contacts->bond[row] == BondState::softening;
      if (!holds || !is_past_end(model, state, *contacts, row)) continue;
      const std::vector<Index> nodes = nodes_of(model, contacts->second[row], is_facet_table);
      const Index particle = contacts->first[row];
      auto pair = std::lower_bound(found.begin(), found.end(), SetupPair{particle, 0});
      for (; pair != found.end() && pair->first == particle; ++pair) {
        const bool is_own = are_facets == is_facet_table && pair->second == contacts->second[row];
        if (!is_own && meet(nodes, nodes_of(model, pair->second, are_facets))) barred.push_back(*pair);
      }
    }
  }
  return barred;
}

SlidingContacts::SlidingContacts(const Model& model, const State& state,
                                 const std::vector<ContactCandidate>& facet_candidates,
                                 const std::vector<ContactCandidate>& corner_candidates) {
  collect<FacetPairing>(model, state, facet_candidates);
  collect<CornerPairing>(model, state, corner_candidates);
  find_heirs(model, facet_candidates, true);
  find_heirs(model, corner_candidates, false);
  std::erase_if(carried_, [](const Carried& contact) { return contact.heir_second < 0; });
}

void SlidingContacts::find_heirs(const Model& model, const std::vector<ContactCandidate>& candidates, bool are_facets) {
  for (const ContactCandidate& candidate : candidates) {
    if (candidate.old_row >= 0) continue;
    const std::vector<Index> nodes = nodes_of(model, candidate.second, are_facets);
    const auto contact = std::find_if(carried_.begin(), carried_.end(), [&](const Carried& carried) {
      return carried.heir_second < 0 && carried.particle == candidate.first && meet(carried.nodes, nodes);
    });
    if (contact == carried_.end()) continue;
    contact->heir_is_facet = are_facets;
    contact->heir_law = candidate.law;
    contact->heir_second = candidate.second;
  }
}

template <class Pairing>
void SlidingContacts::collect(const Model& model, const State& state, const std::vector<ContactCandidate>& candidates) {
  const ContactTable& contacts = Pairing::table(state);
  for (const std::size_t row : dropped_rows(contacts, candidates)) {
    if (!is_past_end(model, state, contacts, row)) continue;
    Carried contact;
    contact.table = &contacts;
    contact.row = row;
    contact.law = contacts.law[row];
    contact.particle = contacts.first[row];
    contact.nodes = nodes_of(model, contacts.second[row], &contacts == &state.facet_contacts);
    contact.reference_distance = contacts.rest_distance[row] - contacts.initial_gap[row];
    contact.shear_displacement = contacts.shear_displacement[row];
    contact.shear_force = contacts.shear_force[row];
    contact.stored = free_contact_energy(contacts, row, Pairing::motion(model, state, row).opening);
    for (const double* value : history_pointers(model, contacts, contact.law, row)) contact.history.push_back(*value);
    carried_.push_back(std::move(contact));
  }
}

const SlidingContacts::Carried* SlidingContacts::find(const ContactTable& contacts, std::size_t row) const {
  const auto found = std::find_if(carried_.begin(), carried_.end(), [&](const Carried& contact) {
    return contact.table == &contacts && contact.row == row;
  });
  return found == carried_.end() ? nullptr : &*found;
}

ContactEnergies SlidingContacts::left_behind(const Model& model, const ContactTable& contacts, std::size_t row) const {
  ContactEnergies energies = contact_energies(model, contacts, row);
  const Carried* contact = find(contacts, row);
  if (contact == nullptr) return energies;
  if (contact->law == contact->heir_law) return {};
  energies.elastic_normal = energies.elastic_shear = 0.0;
  return energies;
}

std::optional<double> SlidingContacts::hand_over(const Model& model, ContactTable& contacts, std::size_t row,
                                                 bool is_facet) const {
  const auto predecessor = std::find_if(carried_.begin(), carried_.end(), [&](const Carried& contact) {
    return contact.particle == contacts.first[row] && contact.heir_is_facet == is_facet &&
           contact.heir_second == contacts.second[row];
  });
  if (predecessor == carried_.end()) return std::nullopt;
  const auto& own_references = is_facet ? model.facet_pairs : model.corner_pairs;
  if (!is_setup_pair(own_references, {contacts.first[row], contacts.second[row]})) {
    const double gap = contacts.rest_distance[row] - predecessor->reference_distance;
    contacts.opening[row] += gap - contacts.initial_gap[row];
    contacts.initial_gap[row] = gap;
  }
  contacts.shear_displacement[row] = predecessor->shear_displacement;
  contacts.shear_force[row] = predecessor->shear_force;
  if (predecessor->law == predecessor->heir_law) {
    const auto history = history_pointers(model, contacts, contacts.law[row], row);
    for (std::size_t k = 0; k < history.size(); ++k) *history[k] = predecessor->history[k];
  }
  return predecessor->stored;
}

}  // namespace ligament
