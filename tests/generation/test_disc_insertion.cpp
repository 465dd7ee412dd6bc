#include <doctest/doctest.h>

#include "core/error.hpp"
#include "generation/disc_insertion.hpp"
#include "reference/all_pairs_search.hpp"

using namespace ligament;

TEST_CASE("inserted discs lie in the box and overlap nowhere") {
  const Vector size{1.3, 0.7};
  Field<double> radii(20, 0.05);
  radii.insert(radii.end(), 300, 0.011);
  radii.insert(radii.end(), 300, 0.002);
  RandomNumbers random(4);
  const Field<Vector> centres = insert_discs(radii, size, random);
  REQUIRE(centres.size() == radii.size());
  CHECK(reference::all_particle_pairs(centres, radii, 0.0).empty());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    for (int axis = 0; axis < dimension; ++axis) {
      CHECK(component(centres[i], axis) >= radii[i]);
      CHECK(component(centres[i], axis) <= component(size, axis) - radii[i]);
    }
  }
}

TEST_CASE("a disc that finds no room is told") {
  const Field<double> radii(3, 0.25);
  RandomNumbers random(5);
  CHECK_THROWS_WITH_AS(insert_discs(radii, {0.9, 0.6}, random), doctest::Contains("found no room"), InputError);
}

TEST_CASE("no discs need no room") {
  RandomNumbers random(6);
  CHECK(insert_discs({}, {1.0, 1.0}, random).empty());
}
