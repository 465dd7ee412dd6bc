#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/facet_search.hpp"
#include "core/error.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/hand_made_model.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

FacetPairs found(const Model& model, const Field<Vector>& centres, const Field<double>& radii, double reach) {
  return find_facet_pairs(
      model.facets, model.nodes.position, centres, radii, [&](Index) { return reach; }, reach);
}

FacetPairs found_by_one(const Model& model, const Vector& centre, double radius, double reach = 0.0) {
  return found(model, {centre}, {radius}, reach);
}

/// A closed outline around the origin with random corners, some reentrant.
Model star(RandomNumbers& random, int n_corners) {
  Model model = empty_model();
  std::vector<Vector> corners;
  for (int i = 0; i < n_corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n_corners;
    corners.push_back(random.uniform(0.5, 1.0) * Vector{std::cos(angle), std::sin(angle)});
  }
  add_outline(model, corners);
  return model;
}

/// A unit square with its sides cut into `n_parts` facets.
Model square(int n_parts) {
  Model model = empty_model();
  std::vector<Vector> corners;
  const std::array<Vector, 5> ends{Vector{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}};
  for (std::size_t side = 0; side < 4; ++side) {
    for (int k = 0; k < n_parts; ++k) {
      corners.push_back(ends[side] + (static_cast<double>(k) / n_parts) * (ends[side + 1] - ends[side]));
    }
  }
  add_outline(model, corners);
  return model;
}

}  // namespace

TEST_CASE("the grid finds the facets and corners that a look at all of them finds") {
  RandomNumbers random(16);
  for (int trial = 0; trial < 20; ++trial) {
    const Model model = star(random, 5 + 3 * trial);
    Field<Vector> centres;
    Field<double> radii;
    for (int i = 0; i < 200; ++i) {
      centres.push_back(random.vector(1.2));
      radii.push_back(trial % 2 == 0 ? 0.05 : random.uniform(0.005, 0.2));
    }
    for (const double reach : {0.0, 0.02}) {
      const FacetPairs pairs = found(model, centres, radii, reach);
      CHECK(pairs.facets == reference::all_facet_pairs(model.facets, model.nodes.position, centres, radii, reach));
      CHECK(pairs.corners == reference::all_corner_pairs(model.facets, model.nodes.position, centres, radii, reach));
    }
  }
}

TEST_CASE("a particle on a facet, outside, far away, and too deep inside") {
  const Model model = square(1);
  CHECK(found_by_one(model, {0.5, 1.09}, 0.1).facets == std::vector<SetupPair>{{0, 2}});
  CHECK(found_by_one(model, {0.5, 0.95}, 0.1).facets == std::vector<SetupPair>{{0, 2}});
  CHECK(found_by_one(model, {0.5, 1.11}, 0.1).facets.empty());
  CHECK(found_by_one(model, {0.5, 1.11}, 0.1, 0.02).facets.size() == 1);
  CHECK(found_by_one(model, {0.5, 0.89}, 0.1).facets.empty());
}

TEST_CASE("a convex corner makes one contact with its node, and none where the particle sees a facet") {
  const Model model = square(1);
  FacetPairs pairs = found_by_one(model, {1.05, 1.05}, 0.1);
  CHECK(pairs.facets.empty());
  CHECK(pairs.corners == std::vector<SetupPair>{{0, 2}});
  pairs = found_by_one(model, {0.99, 1.05}, 0.1);
  CHECK(pairs.facets == std::vector<SetupPair>{{0, 2}});
  CHECK(pairs.corners.empty());
  CHECK(found_by_one(model, {1.08, 1.08}, 0.1).corners.empty());
}

TEST_CASE("in a reentrant corner a particle makes a contact with both facets and none with the node") {
  Model model = empty_model();
  add_outline(model, {{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
  const FacetPairs pairs = found_by_one(model, {1.08, 1.09}, 0.1);
  CHECK(pairs.facets == std::vector<SetupPair>{{0, 2}, {0, 3}});
  CHECK(pairs.corners.empty());
}

TEST_CASE("facets in line make one contact, wherever the particle is, smaller facets than particles too") {
  for (const int n_parts : {1, 3, 10, 60}) {
    const Model model = square(n_parts);
    for (int i = 1; i < 600; ++i) {
      const FacetPairs pairs = found_by_one(model, {i / 600.0, 1.05}, 0.1);
      REQUIRE(pairs.facets.size() + pairs.corners.size() == 1);
      // Above a common node the particle may be at the corner, by rounding.
      if (i % 10 != 0) REQUIRE(pairs.facets.size() == 1);
    }
  }
}

TEST_CASE("every place outside of a slanted polygon makes one contact as long as no corner is reentrant") {
  Model model = empty_model();
  std::vector<Vector> corners;
  for (int i = 0; i < 7; ++i) {
    corners.push_back({std::cos(0.3 + 2.0 * std::numbers::pi * i / 7), std::sin(0.3 + 2.0 * std::numbers::pi * i / 7)});
  }
  add_outline(model, corners);
  RandomNumbers random(17);
  for (int trial = 0; trial < 2000; ++trial) {
    // The polygon lies between the circles of radius cos(π/7) and 1.
    const FacetPairs pairs = found_by_one(model, 1.001 * random.direction(), 0.2);
    REQUIRE(pairs.facets.size() + pairs.corners.size() == 1);
  }
}

TEST_CASE("no particles, no facets") {
  const Model model = square(1);
  CHECK(found(model, {}, {}, 0.1).facets.empty());
  CHECK(found_by_one(empty_model(), {0.0, 0.0}, 0.1).facets.empty());
}

TEST_CASE("a node or centre that is not a number is a divergence") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Model model = square(1);
  CHECK_THROWS_AS(found_by_one(model, {nan, 0.0}, 0.1), DivergenceError);
  model.nodes.position[2] = {1.0, nan};
  CHECK_THROWS_AS(found_by_one(model, {0.5, 1.0}, 0.1), DivergenceError);
}
