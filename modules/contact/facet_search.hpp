#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/model.hpp"

namespace ligament {

/// Particles near facets: those whose centre projects into a facet (particle, facet), and those near a node and beyond
/// the ends there of all its facets (particle, node). Sorted.
struct FacetPairs {
  std::vector<SetupPair> facets;
  std::vector<SetupPair> corners;
};

/// Gap (m) between a particle and a facet up to which they count as a pair.
using FacetReach = std::function<double(Index particle)>;

/// All such pairs at these positions. A particle that sees two facets in line through their common node pairs with the
/// first of them only. Throws DivergenceError if a position is not finite.
FacetPairs find_facet_pairs(const FacetData& facets, std::span<const Vector> node_positions,
                            std::span<const Vector> centres, std::span<const double> radii, const FacetReach& reach,
                            double largest_reach);

/// Where a point lies against a facet: `distance` from its line, > 0 outside of the element; `position` along it from
/// node i; both in m.
struct FacetPlace {
  double distance = 0.0;
  double position = 0.0;
  double length = 0.0;

  [[nodiscard]] bool projects_inside() const { return position >= 0.0 && position < length; }
};
FacetPlace place_at_facet(const Vector& node_i, const Vector& node_j, const Vector& point);

}  // namespace ligament
