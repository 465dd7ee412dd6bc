#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "contact/kinematics.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A vector with more digits.
struct Long {
  long double x;
  long double y;
  Long(const Vector& v) : x(v.x), y(v.y) {}  // NOLINT: the conversion is the point
  Long(long double a, long double b) : x(a), y(b) {}
  friend Long operator+(const Long& a, const Long& b) { return {a.x + b.x, a.y + b.y}; }
};
long double length(const Long& a) { return std::sqrt(a.x * a.x + a.y * a.y); }
long double height(const Long& edge, const Long& centre) {
  return (edge.y * centre.x - edge.x * centre.y) / length(edge);
}

/// Displacements against bodies of size one.
constexpr double scales[] = {1e-1, 1e-3, 1e-5, 1e-8};

/// A few roundings of the displacement, and what the subtraction loses that gives the exact value in long double. The
/// difference of two distances in double would be off by 1e-16.
double allowed_error(double displacement) { return 5e-16 * displacement + 1e-18; }

}  // namespace

TEST_CASE("the opening of two points loses no digits, however small the displacement") {
  RandomNumbers random(3);
  for (const double scale : scales) {
    CAPTURE(scale);
    double largest_error = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
      const Vector rest = random.uniform(0.5, 2.0) * random.direction();
      const Vector displacement = random.vector(scale);
      const double rest_distance = norm(rest);
      const auto motion = particle_pair_motion({rest, displacement, displacement}, {rest_distance, 0.0, 0.0}, {});
      const long double exact = length(Long(rest) + displacement) - length(rest);
      largest_error = std::max(largest_error, std::abs(static_cast<double>(motion.opening - exact)));
      const auto corner = corner_motion({rest, displacement, displacement}, {rest_distance, 0.0, 0.0}, 0.0);
      REQUIRE(corner.opening == motion.opening);
    }
    // Relative to the displacement, not to the opening, which may be of second order.
    CHECK(largest_error < allowed_error(scale));
  }
}

TEST_CASE("the opening from a facet loses no digits, however small the displacement") {
  RandomNumbers random(4);
  for (const double scale : scales) {
    CAPTURE(scale);
    double largest_error = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
      const Vector edge = random.uniform(0.5, 2.0) * random.direction();
      const Vector axial = edge / norm(edge);
      const Vector centre = random.uniform(0.0, norm(edge)) * axial - random.uniform(0.1, 0.5) * tangent(axial);
      const Vector edge_displacement = random.vector(scale);
      const Vector centre_displacement = random.vector(scale);
      const double rest_distance = static_cast<double>(height(edge, centre));
      const auto motion =
          facet_motion({edge, edge_displacement, edge_displacement, centre, centre_displacement, centre_displacement},
                       {rest_distance, 0.0, 0.0}, 0.0);
      const long double exact =
          height(Long(edge) + edge_displacement, Long(centre) + centre_displacement) - height(edge, centre);
      largest_error = std::max(largest_error, std::abs(static_cast<double>(motion.opening - exact)));
    }
    CHECK(largest_error < allowed_error(scale));
  }
}

TEST_CASE("the initial gap shifts the opening") {
  const auto motion = particle_pair_motion({{2.0, 0.0}, {0.5, 0.0}, {0.5, 0.0}}, {2.0, 0.25, 0.25}, {});
  CHECK(motion.opening == doctest::Approx(0.75).epsilon(1e-15));
}

TEST_CASE("the contact point of two discs lies at the middle of their overlap or gap") {
  // Radii 1 and 0.5, centres 1.3 apart: surfaces at 1 and 0.8.
  auto motion = particle_pair_motion({{1.3, 0.0}, {}, {}}, {1.3, 0.0, 0.0}, {.radius_difference = 0.5});
  CHECK(motion.geometry.arm_first == doctest::Approx(0.9).epsilon(1e-15));
  CHECK(motion.geometry.arm_second == doctest::Approx(0.4).epsilon(1e-15));
  CHECK(motion.geometry.normal == Vector{1.0, 0.0});
  // 1.7 apart: surfaces at 1 and 1.2.
  motion = particle_pair_motion({{0.0, 1.7}, {}, {}}, {1.7, 0.0, 0.0}, {.radius_difference = 0.5});
  CHECK(motion.geometry.arm_first == doctest::Approx(1.1).epsilon(1e-15));
  CHECK(motion.geometry.normal == Vector{0.0, 1.0});
}

TEST_CASE("the normal of a facet points from the particle to it, into the solid on its left") {
  const auto motion = facet_motion({{2.0, 0.0}, {}, {}, {0.5, -0.3}, {}, {}}, {0.3, 0.0, 0.0}, 0.0);
  CHECK(motion.geometry.normal == Vector{0.0, 1.0});
  CHECK(motion.geometry.arm_first == doctest::Approx(0.3).epsilon(1e-15));
  CHECK(motion.geometry.arm_second == 0.0);
  CHECK(motion.geometry.share == doctest::Approx(0.25).epsilon(1e-15));
}
