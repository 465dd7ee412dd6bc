#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "generation/disc_growth.hpp"
#include "generation/void_elimination.hpp"
#include "generation/voids.hpp"
#include "reference/grown_circles.hpp"
#include "reference/largest_empty_circle.hpp"

using namespace ligament;

namespace {

/// Discs thrown into a box, so that they leave holes of all sizes and shapes.
Packing loose_discs(const Vector& size, std::uint64_t seed, int count) {
  RandomNumbers random(seed);
  Packing packing;
  for (int i = 0; i < count; ++i) {
    packing.radius.push_back(random.uniform(0.02, 0.15));
    packing.position.push_back({random.uniform(0.0, size.x), random.uniform(0.0, size.y)});
  }
  return packing;
}

std::tuple<double, double, double> values(const Circle& circle) {
  return {circle.radius, circle.centre.x, circle.centre.y};
}

bool is_larger(const Circle& a, const Circle& b) { return values(b) < values(a); }

}  // namespace

TEST_CASE("the largest void is that of a fine grid") {
  const Vector size{1.3, 1.0};
  for (const int count : {1, 2, 5, 40, 150}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      CAPTURE(count);
      CAPTURE(seed);
      const Packing packing = loose_discs(size, seed, count);
      constexpr double spacing = 0.002;
      const double on_grid = reference::largest_empty_circle(packing.position, packing.radius, size, spacing);
      const double found = largest_void(packing.position, packing.radius, size, 0.1 * on_grid);
      CHECK(found >= on_grid);
      CHECK(found <= on_grid + spacing / std::sqrt(2.0));
    }
  }
}

TEST_CASE("a void is found up to its own radius and not beyond") {
  const Vector size{1.0, 1.0};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const Packing packing = loose_discs(size, seed, 60);
    const double largest = largest_void(packing.position, packing.radius, size, 0.01);
    CHECK_FALSE(find_voids(packing.position, packing.radius, size, largest * (1.0 - 1e-6)).empty());
    CHECK(find_voids(packing.position, packing.radius, size, largest * (1.0 + 1e-6)).empty());
    CHECK(largest_void(packing.position, packing.radius, size, largest * (1.0 + 1e-6)) == 0.0);
  }
}

TEST_CASE("voids are empty circles above the limit, the largest first") {
  const Vector size{1.0, 1.0};
  constexpr double limit = 0.02;
  const Packing packing = loose_discs(size, 9, 80);
  const auto voids = find_voids(packing.position, packing.radius, size, limit);
  REQUIRE(voids.size() > 10);
  for (std::size_t i = 0; i < voids.size(); ++i) {
    CHECK(voids[i].radius >= limit);
    if (i > 0) CHECK(voids[i].radius <= voids[i - 1].radius);
    CHECK(reference::clearance(packing.position, packing.radius, size, voids[i].centre) ==
          doctest::Approx(voids[i].radius).epsilon(1e-6));
  }
}

TEST_CASE("voids are those of a search among all pairs that looks at all obstacles at every turn, to the bit") {
  const Vector size{1.3, 1.0};
  constexpr double limit = 0.01;
  std::size_t n_voids = 0;
  for (const int count : {1, 5, 20, 40, 80, 120}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      CAPTURE(count);
      CAPTURE(seed);
      const Packing packing = loose_discs(size, seed, count);
      const auto found = find_voids(packing.position, packing.radius, size, limit);
      auto expected = reference::grown_circles({packing.position, packing.radius, size, limit}, limit);
      std::sort(expected.begin(), expected.end(), is_larger);
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) CHECK(values(found[i]) == values(expected[i]));
      n_voids += found.size();
    }
  }
  CHECK(n_voids > 500);
}

TEST_CASE("an empty box is one void, and a box that a disc covers has none") {
  const auto voids = find_voids({}, {}, {2.0, 1.0}, 0.1);
  REQUIRE_FALSE(voids.empty());
  CHECK(voids.front().radius == doctest::Approx(0.5));
  CHECK(find_voids({{0.5, 0.5}}, {1.0}, {1.0, 1.0}, 1e-3).empty());
}

TEST_CASE("a disc alone leaves the four corners of its box") {
  const auto voids = find_voids({{1.0, 1.0}}, {1.0}, {2.0, 2.0}, 0.1);
  const double root = std::sqrt(2.0);
  std::vector<Circle> corners;
  for (const Circle& hole : voids) {
    CHECK(hole.radius == doctest::Approx((root - 1.0) / (root + 1.0)).epsilon(1e-9));
    const bool is_new = std::none_of(corners.begin(), corners.end(),
                                     [&](const Circle& other) { return norm(hole.centre - other.centre) < 1e-9; });
    if (is_new) corners.push_back(hole);
  }
  CHECK(corners.size() == 4);
}

TEST_CASE("voids off the border are filled until none above the limit is left") {
  const Vector size{1.0, 1.0};
  RandomNumbers random(4);
  Packing packing = grow_discs(Field<double>(60, 0.07), size, random);
  const double limit = 0.01;
  const std::size_t n_before = packing.size();
  REQUIRE(reference::largest_empty_circle(packing.position, packing.radius, size, 0.002) > limit);
  const VoidFilling filling{0.03, limit};
  REQUIRE(filling.border() == doctest::Approx(0.02));
  const std::size_t n_filled = eliminate_voids(packing, size, filling);
  CHECK(n_filled > 0);
  CHECK(packing.size() == n_before + n_filled);
  CHECK(reference::largest_empty_circle(packing.position, packing.radius, size, 0.002, filling.border()) <= limit);
  CHECK(eliminate_voids(packing, size, filling) == 0);
}
