#include <doctest/doctest.h>

#include <algorithm>

#include "generation/near_discs.hpp"
#include "generation/random_numbers.hpp"

using namespace ligament;

namespace {

constexpr double skin = 0.003;

Vector random_point(RandomNumbers& random, double low, double high) {
  const double x = random.uniform(low, high);
  return {x, random.uniform(low, high)};
}

/// All pairs nearer than the skin, the second ones of each disc by their cells: the slow twin.
std::vector<std::pair<Index, Index>> all_pairs(const Field<Vector>& centres, const Field<double>& radii) {
  const CellGrid grid(centres, 2.0 * *std::max_element(radii.begin(), radii.end()) + skin);
  std::vector<std::pair<Index, Index>> pairs;
  for (Index first = 0; first < static_cast<Index>(centres.size()); ++first) {
    for (const Index second : grid.points()) {
      const double gap = norm(centres[second] - centres[first]) - radii[first] - radii[second];
      if (second > first && gap < skin) pairs.emplace_back(first, second);
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("near discs are all pairs within the skin, in the order of a grid, wherever the discs go") {
  RandomNumbers random(11);
  Field<Vector> centres;
  Field<double> radii;
  for (int i = 0; i < 200; ++i) {
    centres.push_back(random_point(random, 0.0, 1.0));
    radii.push_back(random.uniform(0.005, 0.04));
  }
  Field<Vector> velocities(centres.size());
  for (Vector& velocity : velocities) velocity = random_point(random, -1.0, 1.0);
  NearDiscs near(radii, skin);
  std::size_t n_pairs = 0;
  for (int update = 0; update < 100; ++update) {
    near.update(centres);
    std::vector<std::pair<Index, Index>> found;
    for (const DiscPair& pair : near.pairs()) found.emplace_back(pair.first, pair.second);
    REQUIRE(found == all_pairs(centres, radii));
    n_pairs += found.size();
    const double step = random.uniform(0.0, near.most_moved());
    for (std::size_t i = 0; i < centres.size(); ++i) centres[i] += step * velocities[i];
  }
  CHECK(n_pairs > 10000);
}

TEST_CASE("no pair that overlaps is missing until a disc has moved too far") {
  // Two discs that come straight at each other, as fast as they may.
  const Field<double> radii{0.1, 0.1};
  Field<Vector> centres{{0.0, 0.0}, {0.2 + 2.0 * skin, 0.2 + 2.0 * skin}};
  NearDiscs near(radii, skin);
  for (;;) {
    near.update(centres);
    const Vector step = uniform_vector(near.most_moved());
    centres[0] += step;
    centres[1] -= step;
    if (norm(centres[1] - centres[0]) < 0.2) break;
  }
  CHECK(near.pairs().size() == 1);
}
