#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/vector.hpp"

using namespace ligament;

TEST_CASE("products of vectors") {
  const Vector a{3.0, 4.0};
  const Vector b{-2.0, 5.0};
  CHECK(dot(a, b) == 14.0);
  CHECK(norm(a) == 5.0);
  CHECK(cross(a, b) == 23.0);
  CHECK(componentwise(a, b) == Vector{-6.0, 20.0});
  CHECK(a + b == Vector{1.0, 9.0});
  CHECK(a - b == Vector{5.0, -1.0});
  CHECK(-a == Vector{-3.0, -4.0});
  CHECK(2.0 * a == a * 2.0);
  CHECK(a / 2.0 == Vector{1.5, 2.0});
}

TEST_CASE("spin × arm is the velocity of a point of a rigid body") {
  const double angle = 0.3;
  const double step = 1e-6;
  const auto point = [](double turn) { return Vector{2.0 * std::cos(turn), 2.0 * std::sin(turn)}; };
  const Vector difference = (point(angle + step) - point(angle - step)) / (2.0 * step);
  CHECK(norm(cross(1.0, point(angle)) - difference) < 1e-9);
}

TEST_CASE("the tangent is the normal turned by a right angle, counter-clockwise") {
  const Vector normal{0.6, 0.8};
  CHECK(dot(tangent(normal), normal) == 0.0);
  CHECK(cross(normal, tangent(normal)) == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("components are read and set by number") {
  Vector a{1.0, 2.0};
  set_component(a, 1, 7.0);
  set_component(a, 0, -3.0);
  CHECK(component(a, 0) == -3.0);
  CHECK(component(a, 1) == 7.0);
  CHECK(largest_component(a) == 7.0);
}

TEST_CASE("components are kept within limits") {
  CHECK(clamped({-3.0, 4.0}, {2.0, 5.0}) == Vector{-2.0, 4.0});
  CHECK(clamped({-3.0, 4.0}, {0.0, 0.0}) == Vector{0.0, 0.0});
}

TEST_CASE("a vector is finite if all its components are") {
  CHECK(is_finite({1.0, -1e308}));
  CHECK_FALSE(is_finite({1.0, std::numeric_limits<double>::quiet_NaN()}));
  CHECK_FALSE(is_finite({std::numeric_limits<double>::infinity(), 0.0}));
}
