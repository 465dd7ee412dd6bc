#include "contact/grid_contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/cut_pairs.hpp"
#include "contact/dropped_contacts.hpp"
#include "contact/facet_search.hpp"
#include "contact/law_ranges.hpp"
#include "contact/new_contacts.hpp"
#include "contact/particle_search.hpp"
#include "contact/seats.hpp"
#include "contact/sliding_contacts.hpp"
#include "core/block_sum.hpp"
#include "core/largest.hpp"

namespace ligament {
namespace {

Field<Vector> current_positions(const Field<Vector>& rest, const Field<Vector>& displacement) {
  Field<Vector> positions(rest.size());
  std::transform(rest.begin(), rest.end(), displacement.begin(), positions.begin(), std::plus<>());
  return positions;
}

[[gnu::target_clones("avx512f", "avx2", "default")]] Largest largest_square(std::size_t count,
                                                                            const Vector* __restrict displacement,
                                                                            const Vector* __restrict last) {
  Largest square;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (int axis = 0; axis < dimension; ++axis) {
      const double travel = component(displacement[i], axis) - component(last[i], axis);
      sum += travel * travel;
    }
    square.see(sum);
  }
  return square;
}

Largest largest_square(const Field<Vector>& displacement, const Field<Vector>& last) {
  return sum_of_body_blocks(last.size(), [&](std::size_t begin, std::size_t end) {
    return largest_square(end - begin, displacement.data() + begin, last.data() + begin);
  });
}

/// The square of how far bodies have gone since the last update, at most (m2); not a number if one is none.
double largest_travel_square(const State& state) {
  Largest square = largest_square(state.particles.translation.displacement, state.search.particle_displacement);
  square += largest_square(state.nodes.translation.displacement, state.search.node_displacement);
  return square.value();
}

/// Gap up to which a pair of particles is bonded at set-up: the larger one of their zones.
double bond_reach(const Model& model, Index a, Index b) {
  const auto& zone = model.particles.zone;
  const double gap = std::max(model.zones[zone[a]].detection_gap, model.zones[zone[b]].detection_gap);
  return gap * (model.particles.radius[a] + model.particles.radius[b]);
}

double interface_reach(const Model& model, Index particle) {
  return model.zones[model.particles.zone[particle]].interface_gap * model.particles.radius[particle];
}

template <class Reach>
double largest_over_particles(const Model& model, Reach&& reach) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.particles.size(); ++i) largest = std::max(largest, reach(static_cast<Index>(i)));
  return largest;
}

/// The law of a pair that is new.
Index law_of_new(const PairLaws& laws, bool is_bonded) {
  return is_bonded && laws.bond >= 0 ? laws.bond : laws.contact;
}

/// Whether set-up bonds a pair: one that is near and that no notch separates.
bool gets_bond(const std::vector<SetupPair>& pairs, const std::vector<SetupPair>& cut_pairs, const SetupPair& pair) {
  return is_setup_pair(pairs, pair) && !is_setup_pair(cut_pairs, pair);
}

bool holds(BondState bond) { return bond == BondState::bonded || bond == BondState::softening; }

/// A contact of a table and its row.
struct KnownContact {
  SetupPair pair;
  Index row = 0;
  friend auto operator<=>(const KnownContact&, const KnownContact&) = default;
};

/// All contacts of a table, sorted by their pairs.
std::vector<KnownContact> known_contacts(const ContactTable& contacts) {
  std::vector<KnownContact> known(contacts.size());
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    known[row] = {{contacts.first[row], contacts.second[row]}, static_cast<Index>(row)};
  }
  // Those of each law are.
  if (!std::is_sorted(known.begin(), known.end())) std::sort(known.begin(), known.end());
  return known;
}

/// The pairs found, sorted, joined by the bonds of the table, which hold at any distance, each with the row it has now.
/// `law_of` tells the law of new pairs.
template <class LawOf>
std::vector<ContactCandidate> candidates(const ContactTable& contacts, const std::vector<SetupPair>& found,
                                         LawOf&& law_of) {
  std::vector<ContactCandidate> all;
  const auto keep = [&](const KnownContact& known) {
    all.push_back({contacts.law[known.row], known.pair.first, known.pair.second, known.row});
  };
  auto pair = found.begin();
  const auto add_new_before = [&](const SetupPair& end) {
    for (; pair != found.end() && *pair < end; ++pair) all.push_back({law_of(*pair), pair->first, pair->second, -1});
  };
  for (const KnownContact& known : known_contacts(contacts)) {
    add_new_before(known.pair);
    const bool is_found = pair != found.end() && *pair == known.pair;
    if (is_found || holds(contacts.bond[known.row])) keep(known);
    if (is_found) ++pair;
  }
  add_new_before({std::numeric_limits<Index>::max(), 0});
  return all;
}

void book_dropped(const Model& model, const ContactTable& contacts, const std::vector<ContactCandidate>& kept,
                  const SlidingContacts* sliding, EnergyLedger& ledger) {
  for (const std::size_t row : dropped_rows(contacts, kept)) {
    book_dropped_contact(
        sliding != nullptr ? sliding->left_behind(model, contacts, row) : contact_energies(model, contacts, row),
        ledger);
  }
}

/// A contact found with an overlap brings energy that nobody gave, unless its predecessor stored it.
void book_found(const ContactTable& contacts, std::size_t row, double stored_before, EnergyLedger& ledger) {
  book_found_contact(free_contact_energy(contacts, row, contacts.opening[row]) - stored_before, ledger);
}

/// By how much the reference distance of a particle at the interface exceeds its radius (m), at most; nothing if it
/// overlaps. Its contacts there are listed from that much farther away.
Field<double> interface_excess(const Model& model) {
  Field<double> excess(model.particles.size(), 0.0);
  const auto see = [&](Index particle, double distance) {
    excess[particle] = std::max(excess[particle], distance - model.particles.radius[particle]);
  };
  for (const SetupPair& pair : model.facet_pairs) see(pair.first, facet_rest_distance(model, pair));
  for (const SetupPair& pair : model.corner_pairs) see(pair.first, corner_rest_distance(model, pair));
  return excess;
}

/// The same for two particles of set-up.
double setup_pair_excess(const Model& model, const SetupPair& pair) {
  const double radii = model.particles.radius[pair.first] + model.particles.radius[pair.second];
  return std::max(0.0, particle_rest_distance(model, pair) - radii);
}

/// The same for any two.
double pair_excess(const Model& model, const SetupPair& pair) {
  return is_setup_pair(model.particle_pairs, pair) ? setup_pair_excess(model, pair) : 0.0;
}

void remove_pairs(std::vector<SetupPair>& pairs, const std::vector<SetupPair>& unwanted) {
  std::erase_if(pairs, [&](const SetupPair& pair) {
    return std::find(unwanted.begin(), unwanted.end(), pair) != unwanted.end();
  });
}

/// Particles near facets and corners where they are now, without those that a bond bars.
FacetPairs find_interface_pairs(const Model& model, const State& state, double skin) {
  const Field<Vector> centres = current_positions(model.particles.position, state.particles.translation.displacement);
  const Field<Vector> nodes = current_positions(model.nodes.position, state.nodes.translation.displacement);
  const Field<double> excess = interface_excess(model);
  const double largest_excess = excess.empty() ? 0.0 : *std::max_element(excess.begin(), excess.end());
  FacetPairs found = find_facet_pairs(
      model.facets, nodes, centres, model.particles.radius, [&](Index i) { return skin + excess[i]; },
      skin + largest_excess);
  remove_pairs(found.facets, barred_by_bonds(model, state, found.facets, true));
  remove_pairs(found.corners, barred_by_bonds(model, state, found.corners, false));
  return found;
}

}  // namespace

void GridContactDetector::bond(Model& model, State& state) {
  const auto& particles = model.particles;
  const double largest_radius = largest_over_particles(model, [&](Index i) { return particles.radius[i]; });
  double largest_gap = 0.0;
  for (const Zone& zone : model.zones) largest_gap = std::max(largest_gap, zone.detection_gap);
  model.particle_pairs = find_particle_pairs(particles.position, particles.radius,
                                             [&](Index a, Index b) { return bond_reach(model, a, b); },
                                             {.largest = 2.0 * largest_gap * largest_radius});
  const FacetPairs facet_pairs = find_facet_pairs(
      model.facets, model.nodes.position, particles.position, particles.radius,
      [&](Index i) { return interface_reach(model, i); },
      largest_over_particles(model, [&](Index i) { return interface_reach(model, i); }));
  model.facet_pairs = facet_pairs.facets;
  model.corner_pairs = facet_pairs.corners;
  find_cut_pairs(model);

  for (ContactTable* table : {&state.particle_contacts, &state.facet_contacts, &state.corner_contacts}) {
    *table = {};
    rebuild_rows(model, *table, {});
  }
  open_dropped_energies(state.ledger);
  rebuild_particle_contacts(model, state, true);
  rebuild_interface_contacts(model, state, true);
  make_seats(model, state);
  state.search.particle_displacement = state.particles.translation.displacement;
  state.search.node_displacement = state.nodes.translation.displacement;
}

bool GridContactDetector::update(const Model& model, State& state) {
  if (largest_travel_square(state) <= reach() * reach()) return false;
  rebuild_particle_contacts(model, state, false);
  rebuild_interface_contacts(model, state, false);
  state.search.particle_displacement = state.particles.translation.displacement;
  state.search.node_displacement = state.nodes.translation.displacement;
  ++state.search.n_updates;
  return true;
}

double GridContactDetector::spare_travel(const Model& /*model*/, const State& state) const {
  return reach() - std::sqrt(largest_travel_square(state));
}

void GridContactDetector::rebuild_particle_contacts(const Model& model, State& state, bool is_setup) const {
  const Field<Vector> centres = current_positions(model.particles.position, state.particles.translation.displacement);
  double largest_excess = 0.0;
  for (const SetupPair& pair : model.particle_pairs) {
    largest_excess = std::max(largest_excess, setup_pair_excess(model, pair));
  }
  std::vector<SetupPair> found = find_particle_pairs(centres, model.particles.radius,
                                                     [&](Index a, Index b) {
                                                       return skin_ + pair_excess(model, {a, b});
                                                     },
                                                     {.smallest = skin_, .largest = skin_ + largest_excess});
  if (is_setup) {
    found.insert(found.end(), model.particle_pairs.begin(), model.particle_pairs.end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  ContactTable& contacts = state.particle_contacts;
  const std::vector<ContactCandidate> kept = candidates(contacts, found, [&](const SetupPair& pair) {
    return law_of_new(particle_laws(model, pair),
                      is_setup && gets_bond(model.particle_pairs, model.cut_particle_pairs, pair));
  });
  book_dropped(model, contacts, kept, nullptr, state.ledger);
  for (const std::size_t row : rebuild_rows(model, contacts, kept)) {
    fill_particle_contact(model, state, contacts, row);
    if (!is_setup) book_found(contacts, row, 0.0, state.ledger);
  }
}

void GridContactDetector::rebuild_interface_contacts(const Model& model, State& state, bool is_setup) const {
  FacetPairs found = find_interface_pairs(model, state, skin_);
  const auto join = [is_setup](std::vector<SetupPair>& pairs, const std::vector<SetupPair>& bonded) {
    if (is_setup) pairs.insert(pairs.end(), bonded.begin(), bonded.end());
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  };
  join(found.facets, model.facet_pairs);
  join(found.corners, model.corner_pairs);

  const auto facet_candidates = candidates(state.facet_contacts, found.facets, [&](const SetupPair& pair) {
    return law_of_new(facet_laws(model, pair), is_setup && gets_bond(model.facet_pairs, model.cut_facet_pairs, pair));
  });
  const auto corner_candidates = candidates(state.corner_contacts, found.corners, [&](const SetupPair& pair) {
    return law_of_new(corner_laws(model, pair),
                      is_setup && gets_bond(model.corner_pairs, model.cut_corner_pairs, pair));
  });

  const SlidingContacts sliding(model, state, facet_candidates, corner_candidates);
  book_dropped(model, state.facet_contacts, facet_candidates, &sliding, state.ledger);
  book_dropped(model, state.corner_contacts, corner_candidates, &sliding, state.ledger);
  const auto welcome = [&](ContactTable& contacts, const std::vector<ContactCandidate>& kept, bool is_facet,
                           auto&& fill) {
    for (const std::size_t row : rebuild_rows(model, contacts, kept)) {
      fill(model, state, contacts, row);
      const std::optional<double> stored_before = sliding.hand_over(model, contacts, row, is_facet);
      if (!is_setup) book_found(contacts, row, stored_before.value_or(0.0), state.ledger);
    }
  };
  welcome(state.facet_contacts, facet_candidates, true, fill_facet_contact);
  welcome(state.corner_contacts, corner_candidates, false, fill_corner_contact);
}

std::vector<EnergyTerm> GridContactDetector::energies(const Model& /*model*/, const State& state) const {
  const ContactEnergies energies = dropped_energies(state.ledger);
  return {{"fracture_tension", EnergyKind::dissipated, energies.fracture_tension},
          {"fracture_shear", EnergyKind::dissipated, energies.fracture_shear},
          {"friction", EnergyKind::dissipated, energies.friction},
          {"contacts_lost", EnergyKind::dissipated, energies.elastic_normal}};
}

}  // namespace ligament
