#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/particle_search.hpp"
#include "core/cell_grid.hpp"
#include "core/error.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

struct Discs {
  Field<Vector> centres;
  Field<double> radii;
};

Discs random_discs(std::uint64_t seed, int count, double smallest, double largest) {
  RandomNumbers random(seed);
  Discs discs;
  for (int i = 0; i < count; ++i) {
    discs.centres.push_back(random.vector(1.0));
    discs.radii.push_back(random.uniform(smallest, largest));
  }
  return discs;
}

std::vector<SetupPair> found(const Discs& discs, double reach) {
  return find_particle_pairs(discs.centres, discs.radii, [&](Index, Index) { return reach; }, {.largest = reach});
}

}  // namespace

TEST_CASE("the grid finds the pairs that a look at all pairs finds, whatever the sizes") {
  for (const double smallest : {0.05, 0.005, 0.0001}) {
    for (const double reach : {0.0, 0.01, 0.3}) {
      const Discs discs = random_discs(11, 500, smallest, 0.05);
      const auto expected = reference::all_particle_pairs(discs.centres, discs.radii, reach);
      REQUIRE(expected.size() > 200);
      CHECK(found(discs, reach) == expected);
    }
  }
}

TEST_CASE("pairs are sorted, first before second") {
  const auto pairs = found(random_discs(12, 300, 0.01, 0.1), 0.0);
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
  CHECK(std::all_of(pairs.begin(), pairs.end(), [](const SetupPair& pair) { return pair.first < pair.second; }));
}

TEST_CASE("a reach of its own for every pair is kept to") {
  const Discs discs = random_discs(13, 200, 0.01, 0.02);
  const auto reach = [](Index a, Index b) { return (a + b) % 3 == 0 ? 0.1 : 0.0; };
  auto expected = reference::all_particle_pairs(discs.centres, discs.radii, 0.1);
  std::erase_if(expected, [&](const SetupPair& pair) {
    const double gap = norm(discs.centres[pair.second] - discs.centres[pair.first]) - discs.radii[pair.first] -
                       discs.radii[pair.second];
    return gap > reach(pair.first, pair.second);
  });
  CHECK(find_particle_pairs(discs.centres, discs.radii, reach, {.largest = 0.1}) == expected);
  CHECK(find_particle_pairs(discs.centres, discs.radii, reach, {.smallest = 0.0, .largest = 0.1}) == expected);
}

TEST_CASE("no discs, one disc, discs in one place, discs in a line") {
  CHECK(found({}, 0.1).empty());
  CHECK(found({{{1.0, 2.0}}, {0.1}}, 0.1).empty());
  CHECK(found({{{1.0, 2.0}, {1.0, 2.0}}, {0.1, 0.1}}, 0.0).size() == 1);
  Discs line;
  for (int i = 0; i < 100; ++i) {
    line.centres.push_back({0.0, 0.2 * i});
    line.radii.push_back(0.1);
  }
  CHECK(found(line, 1e-9).size() == 99);
}

TEST_CASE("two discs far apart do not make a grid larger than memory") {
  const Discs discs{{{0.0, 0.0}, {1e9, 1e9}, {1e9 + 1.5e-3, 1e9}}, {1e-3, 1e-3, 1e-3}};
  const auto pairs = found(discs, 0.0);
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0] == SetupPair{1, 2});
}

TEST_CASE("a position that is not a number is a divergence") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(found({{{0.0, 0.0}, {nan, 0.0}}, {0.1, 0.1}}, 0.0), DivergenceError);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(found({{{0.0, 0.0}, {0.0, infinity}}, {0.1, 0.1}}, 0.0), DivergenceError);
}

TEST_CASE("a box is answered with all points inside, each once, in the same order every time") {
  const Discs discs = random_discs(14, 400, 0.01, 0.01);
  const CellGrid grid(discs.centres, 0.13);
  RandomNumbers random(15);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector low = random.vector(1.5);
    const Vector high = low + Vector{random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)};
    std::vector<Index> seen;
    grid.visit_box(low, high, [&](Index i) { seen.push_back(i); });
    std::vector<Index> again;
    grid.visit_box(low, high, [&](Index i) { again.push_back(i); });
    CHECK(seen == again);
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
    for (std::size_t i = 0; i < discs.centres.size(); ++i) {
      const Vector& place = discs.centres[i];
      const bool is_inside = place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
      if (is_inside) REQUIRE(std::binary_search(seen.begin(), seen.end(), static_cast<Index>(i)));
    }
  }
}
