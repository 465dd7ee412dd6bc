#include <doctest/doctest.h>

#include <cmath>

#include "generation/tangent_circles.hpp"

using namespace ligament;

TEST_CASE("three equal discs in touch: the circle between them has R(2/√3 - 1)") {
  const double height = std::sqrt(3.0);
  const auto circles =
      tangent_circles({Circle{{4.0, 2.0}, 1.0}, Circle{{6.0, 2.0}, 1.0}, Circle{{5.0, 2.0 + height}, 1.0}});
  REQUIRE(circles.size() == 1);
  CHECK(circles[0].radius == doctest::Approx(2.0 / height - 1.0).epsilon(1e-12));
  CHECK(norm(circles[0].centre - Vector{5.0, 2.0 + height / 3.0}) < 1e-12);
}

TEST_CASE("discs of three sizes: the circle touches each of them from outside") {
  const std::array<Circle, 3> discs{Circle{{0.0, 0.0}, 1.0}, Circle{{3.2, 0.1}, 2.0}, Circle{{0.9, 2.7}, 1.5}};
  const auto circles = tangent_circles({discs[0], discs[1], discs[2]});
  REQUIRE_FALSE(circles.empty());
  for (const Circle& circle : circles) {
    for (const Circle& disc : discs) {
      CHECK(norm(circle.centre - disc.centre) == doctest::Approx(circle.radius + disc.radius).epsilon(1e-12));
    }
  }
}

TEST_CASE("a disc in the corner of two walls: the circle behind it") {
  // On the diagonal: √2 (1 - ρ) = 1 + ρ.
  const double root = std::sqrt(2.0);
  const auto circles =
      tangent_circles({touches_wall({1.0, 0.0}, 0.0), Circle{{1.0, 1.0}, 1.0}, touches_wall({0.0, 1.0}, 0.0)});
  REQUIRE(circles.size() == 2);
  const double smaller = std::min(circles[0].radius, circles[1].radius);
  const double larger = std::max(circles[0].radius, circles[1].radius);
  CHECK(smaller == doctest::Approx((root - 1.0) / (root + 1.0)).epsilon(1e-12));
  CHECK(larger == doctest::Approx((root + 1.0) / (root - 1.0)).epsilon(1e-12));
  for (const Circle& circle : circles) CHECK(norm(circle.centre - uniform_vector(circle.radius)) < 1e-12);
}

TEST_CASE("a circle of given radius in touch with two discs lies on either side of them") {
  const auto circles = tangent_circles({Circle{{0.0, 0.0}, 1.0}, has_radius(1.0), Circle{{2.0, 0.0}, 1.0}});
  REQUIRE(circles.size() == 2);
  for (const Circle& circle : circles) {
    CHECK(circle.radius == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(circle.centre.x == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(std::abs(circle.centre.y) == doctest::Approx(std::sqrt(3.0)).epsilon(1e-14));
  }
  CHECK(circles[0].centre.y * circles[1].centre.y < 0.0);
}

TEST_CASE("no disc at all: a circle between three walls") {
  const auto circles =
      tangent_circles({touches_wall({1.0, 0.0}, 0.0), touches_wall({-1.0, 0.0}, -3.0), touches_wall({0.0, 1.0}, 0.0)});
  REQUIRE(circles.size() == 1);
  CHECK(circles[0].radius == doctest::Approx(1.5));
  CHECK(norm(circles[0].centre - Vector{1.5, 1.5}) < 1e-14);
}

TEST_CASE("where no circle can touch all three there is none") {
  CHECK(tangent_circles({Circle{{0.0, 0.0}, 1.0}, Circle{{5.0, 0.0}, 1.0}, has_radius(1.0)}).empty());
  CHECK(tangent_circles({touches_wall({1.0, 0.0}, 0.0), touches_wall({-1.0, 0.0}, -3.0), has_radius(1.0)}).empty());
  CHECK(tangent_circles({Circle{{0.0, 0.0}, 1.0}, Circle{{3.0, 0.0}, 1.0}, Circle{{6.0, 0.0}, 1.0}}).empty());
}
