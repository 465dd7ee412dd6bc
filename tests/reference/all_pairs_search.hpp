#pragma once

#include <span>
#include <vector>

#include "core/model.hpp"

/// Searches that look at every pair: the slow and obvious twins of the grid searches.
namespace ligament::reference {

/// Pairs of discs whose gap is at most `reach`, first < second, in order.
inline std::vector<SetupPair> all_particle_pairs(std::span<const Vector> centres, std::span<const double> radii,
                                                 double reach) {
  std::vector<SetupPair> pairs;
  for (std::size_t a = 0; a < centres.size(); ++a) {
    for (std::size_t b = a + 1; b < centres.size(); ++b) {
      if (norm(centres[b] - centres[a]) - (radii[a] + radii[b]) <= reach) {
        pairs.push_back({static_cast<Index>(a), static_cast<Index>(b)});
      }
    }
  }
  return pairs;
}

/// Place of a point along a facet in units of its length, and its distance on the right of it.
struct PlaceOnFacet {
  double along;
  double away;
};

inline PlaceOnFacet place_on_facet(const Vector& i, const Vector& j, const Vector& point) {
  const Vector edge = j - i;
  return {dot(edge, point - i) / dot(edge, edge), cross(point - i, edge) / norm(edge)};
}

/// (particle, facet): the centre projects into the facet, at most R + reach outside of the solid and less than R
/// inside.
inline std::vector<SetupPair> all_facet_pairs(const FacetData& facets, std::span<const Vector> nodes,
                                              std::span<const Vector> centres, std::span<const double> radii,
                                              double reach) {
  std::vector<SetupPair> pairs;
  for (std::size_t p = 0; p < centres.size(); ++p) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const PlaceOnFacet place = place_on_facet(nodes[facets.nodes[f][0]], nodes[facets.nodes[f][1]], centres[p]);
      const bool is_inside = place.along >= 0.0 && place.along < 1.0;
      if (is_inside && place.away <= radii[p] + reach && place.away > -radii[p]) {
        pairs.push_back({static_cast<Index>(p), static_cast<Index>(f)});
      }
    }
  }
  return pairs;
}

/// (particle, node): within R + reach of a node, which is the nearest point of all facets that it joins.
inline std::vector<SetupPair> all_corner_pairs(const FacetData& facets, std::span<const Vector> nodes,
                                               std::span<const Vector> centres, std::span<const double> radii,
                                               double reach) {
  std::vector<SetupPair> pairs;
  for (std::size_t p = 0; p < centres.size(); ++p) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (norm(nodes[n] - centres[p]) > radii[p] + reach) continue;
      bool has_facet = false;
      bool is_nearest = true;
      for (const auto& [i, j] : facets.nodes) {
        const auto node = static_cast<Index>(n);
        if (i != node && j != node) continue;
        has_facet = true;
        const double along = place_on_facet(nodes[i], nodes[j], centres[p]).along;
        is_nearest = is_nearest && (i == node ? along < 0.0 : along >= 1.0);
      }
      if (has_facet && is_nearest) pairs.push_back({static_cast<Index>(p), static_cast<Index>(n)});
    }
  }
  return pairs;
}

}  // namespace ligament::reference
