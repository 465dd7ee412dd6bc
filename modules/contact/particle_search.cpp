#include "contact/particle_search.hpp"

#include <algorithm>

#include "core/cell_grid.hpp"

namespace ligament {

std::vector<SetupPair> find_particle_pairs(std::span<const Vector> centres, std::span<const double> radii,
                                           const PairReach& reach, double largest_reach) {
  std::vector<SetupPair> pairs;
  if (radii.empty()) return pairs;
  const double largest_radius = *std::max_element(radii.begin(), radii.end());
  const CellGrid grid(centres, 2.0 * largest_radius + largest_reach);
  for (std::size_t a = 0; a < centres.size(); ++a) {
    const auto first = static_cast<Index>(a);
    const double range = radii[a] + largest_radius + largest_reach;
    grid.visit_box(centres[a] - uniform_vector(range), centres[a] + uniform_vector(range), [&](Index second) {
      if (second <= first) return;
      const double distance = norm(centres[second] - centres[first]);
      if (distance - (radii[first] + radii[second]) <= reach(first, second)) pairs.push_back({first, second});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace ligament
