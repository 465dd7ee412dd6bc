#include "contact/particle_search.hpp"

#include <algorithm>

#include "core/cell_grid.hpp"

namespace ligament {

std::vector<SetupPair> find_particle_pairs(std::span<const Vector> centres, std::span<const double> radii,
                                           const PairReach& reach, const ReachBounds& bounds) {
  std::vector<SetupPair> pairs;
  if (radii.empty()) return pairs;
  const double largest_radius = *std::max_element(radii.begin(), radii.end());
  const CellGrid grid(centres, 2.0 * largest_radius + bounds.largest);
  for (std::size_t a = 0; a < centres.size(); ++a) {
    const auto first = static_cast<Index>(a);
    const double range = radii[a] + largest_radius + bounds.largest;
    grid.visit_box(centres[a] - uniform_vector(range), centres[a] + uniform_vector(range), [&](Index second) {
      if (second <= first) return;
      const double gap = norm(centres[second] - centres[first]) - (radii[first] + radii[second]);
      if (gap > bounds.largest) return;
      if (gap <= bounds.smallest || gap <= reach(first, second)) pairs.push_back({first, second});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace ligament
