#include "contact/facet_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/cell_grid.hpp"
#include "core/error.hpp"

namespace ligament {
namespace {

struct Surroundings {
  const FacetData& facets;
  std::span<const Vector> nodes;
  std::span<const Vector> centres;
  std::span<const double> radii;

  [[nodiscard]] FacetPlace place(const SetupPair& pair) const {
    const auto& [i, j] = facets.nodes[pair.second];
    return place_at_facet(nodes[i], nodes[j], centres[pair.first]);
  }
  [[nodiscard]] bool share_contact_point(const SetupPair& a, const SetupPair& b) const {
    const FacetPlace place_a = place(a);
    const FacetPlace place_b = place(b);
    const auto contact_point = [&](const SetupPair& pair, const FacetPlace& at) {
      const auto& [i, j] = facets.nodes[pair.second];
      return nodes[i] + (at.position / at.length) * (nodes[j] - nodes[i]);
    };
    const double apart = norm(contact_point(a, place_a) - contact_point(b, place_b));
    return apart <= 1e-9 * std::min(place_a.length, place_b.length);
  }
};

void check_finite(std::span<const Vector> nodes) {
  const auto bad = std::find_if_not(nodes.begin(), nodes.end(), is_finite);
  if (bad != nodes.end()) {
    throw DivergenceError(fmt::format("the position of node row {} is not finite", bad - nodes.begin()));
  }
}

/// First of the pairs at the end of a sorted list that belong to a particle.
std::ptrdiff_t begin_of_particle(const std::vector<SetupPair>& pairs, Index particle) {
  return std::lower_bound(pairs.begin(), pairs.end(), SetupPair{particle, 0}) - pairs.begin();
}

/// Drops the later one of two facets that meet where the centre projects.
void drop_double_contacts(const Surroundings& bodies, std::vector<SetupPair>& pairs) {
  std::vector<SetupPair> kept;
  for (const SetupPair& pair : pairs) {
    const auto double_contact = std::find_if(kept.begin() + begin_of_particle(kept, pair.first), kept.end(),
                                             [&](const SetupPair& e) { return bodies.share_contact_point(e, pair); });
    if (double_contact == kept.end()) kept.push_back(pair);
  }
  pairs = std::move(kept);
}

/// Counts, for every particle and node near it, the facets of the node beyond whose end there the particle lies.
using FacetsBehind = std::map<SetupPair, int>;

/// A particle is at a corner if it lies beyond the ends there of all facets that the corner joins: the node is the
/// nearest point of them.
std::vector<SetupPair> corners(const FacetData& facets, std::size_t n_nodes, const FacetsBehind& facets_behind) {
  std::vector<int> n_facets(n_nodes, 0);
  for (const auto& nodes : facets.nodes) {
    for (const Index node : nodes) ++n_facets[node];
  }
  std::vector<SetupPair> pairs;
  for (const auto& [pair, count] : facets_behind) {
    if (count == n_facets[pair.second]) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

FacetPlace place_at_facet(const Vector& node_i, const Vector& node_j, const Vector& point) {
  const Vector edge = node_j - node_i;
  const double length = norm(edge);
  return {-cross(edge, point - node_i) / length, dot(edge, point - node_i) / length, length};
}

FacetPairs find_facet_pairs(const FacetData& facets, std::span<const Vector> node_positions,
                            std::span<const Vector> centres, std::span<const double> radii, const FacetReach& reach,
                            double largest_reach) {
  FacetPairs pairs;
  if (radii.empty()) return pairs;
  check_finite(node_positions);
  const Surroundings bodies{facets, node_positions, centres, radii};
  const double range = *std::max_element(radii.begin(), radii.end()) + largest_reach;
  const CellGrid grid(centres, 2.0 * range);
  FacetsBehind facets_behind;
  for (std::size_t row = 0; row < facets.size(); ++row) {
    const auto facet = static_cast<Index>(row);
    const Index i = facets.nodes[row][0];
    const Index j = facets.nodes[row][1];
    const Vector& a = node_positions[i];
    const Vector& b = node_positions[j];
    const Vector low{std::min(a.x, b.x) - range, std::min(a.y, b.y) - range};
    const Vector high{std::max(a.x, b.x) + range, std::max(a.y, b.y) + range};
    grid.visit_box(low, high, [&](Index particle) {
      const double limit = radii[particle] + reach(particle);
      const FacetPlace place = place_at_facet(a, b, centres[particle]);
      if (place.projects_inside()) {
        // Behind the facet, by more than a radius, is another side of the body.
        if (place.distance <= limit && place.distance > -radii[particle]) pairs.facets.push_back({particle, facet});
        return;
      }
      const Index node = place.position < 0.0 ? i : j;
      if (norm(node_positions[node] - centres[particle]) <= limit) ++facets_behind[{particle, node}];
    });
  }
  std::sort(pairs.facets.begin(), pairs.facets.end());
  drop_double_contacts(bodies, pairs.facets);
  pairs.corners = corners(facets, node_positions.size(), facets_behind);
  return pairs;
}

}  // namespace ligament
