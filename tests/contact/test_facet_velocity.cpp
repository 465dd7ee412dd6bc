#include <doctest/doctest.h>

#include <cmath>

#include "contact/kinematics.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A facet i→j with moving nodes and a disc on its right.
struct MovingFacet {
  Vector node_i;
  Vector node_j;
  Vector velocity_i;
  Vector velocity_j;
  Vector centre;
  Vector velocity;
  Spin spin = 0.0;

  [[nodiscard]] double length() const { return norm(node_j - node_i); }
  [[nodiscard]] Vector axial() const { return (node_j - node_i) / length(); }
  [[nodiscard]] Vector normal() const { return tangent(axial()); }
  [[nodiscard]] double position() const { return dot(centre - node_i, axial()); }
  [[nodiscard]] Vector contact_point() const { return node_i + position() * axial(); }
};

MovingFacet random_facet(RandomNumbers& random) {
  MovingFacet facet;
  facet.node_i = random.vector(1.0);
  facet.node_j = facet.node_i + random.uniform(0.5, 2.0) * random.direction();
  facet.velocity_i = random.vector(1.0);
  facet.velocity_j = random.vector(1.0);
  facet.centre =
      facet.node_i + random.uniform(0.0, facet.length()) * facet.axial() - random.uniform(0.1, 0.5) * facet.normal();
  facet.velocity = random.vector(1.0);
  facet.spin = random.uniform(-1.0, 1.0);
  return facet;
}

/// Eqs (7)-(12) and (15): the facet as a rigid wall about the point of it that has the mean transverse velocity, axial
/// velocity interpolated.
Vector wall_velocity(const MovingFacet& facet) {
  const double transverse_i = dot(facet.velocity_i, facet.normal());
  const double transverse_j = dot(facet.velocity_j, facet.normal());
  const double rigid = 0.5 * (transverse_i + transverse_j);                                    // (7)
  const double cg = -(transverse_i - rigid) * facet.length() / (transverse_j - transverse_i);  // (8)
  const Spin spin = -(transverse_i - rigid) / cg;  // (10); counter-clockwise where node j moves ahead along n
  const Vector centre_of_gravity = facet.node_i + cg * facet.axial();  // (9)
  const double share = facet.position() / facet.length();
  const double axial =
      (1.0 - share) * dot(facet.velocity_i, facet.axial()) + share * dot(facet.velocity_j, facet.axial());  // (12)
  return rigid * facet.normal() + cross(spin, facet.contact_point() - centre_of_gravity) + axial * facet.axial();
}

/// Eqs (13)-(14): of the facet against the disc.
Vector contact_velocity(const MovingFacet& facet, const Vector& facet_velocity) {
  return facet_velocity - (facet.velocity + cross(facet.spin, facet.contact_point() - facet.centre));
}

/// What the kinematics make of a step that ends at the given place.
ContactMotion step_motion(const MovingFacet& facet, double time_step) {
  // The step is centred on the place given.
  const auto half_back = [&](const Vector& place, const Vector& velocity) {
    return place - 0.5 * time_step * velocity;
  };
  const Vector node_i = half_back(facet.node_i, facet.velocity_i);
  const Vector edge = half_back(facet.node_j, facet.velocity_j) - node_i;
  const Vector centre = half_back(facet.centre, facet.velocity) - node_i;
  const Vector edge_step = time_step * (facet.velocity_j - facet.velocity_i);
  const Vector centre_step = time_step * (facet.velocity - facet.velocity_i);
  const double rest_distance = -cross(edge, centre) / norm(edge);
  return facet_motion({edge, edge_step, edge_step, centre, centre_step, centre_step}, {rest_distance, 0.0, 0.0},
                      time_step * facet.spin);
}

}  // namespace

TEST_CASE("the interpolated velocity of a facet is that of the paper's equivalent wall, Eqs (7)-(15)") {
  RandomNumbers random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const MovingFacet facet = random_facet(random);
    const double share = facet.position() / facet.length();
    const Vector interpolated = (1.0 - share) * facet.velocity_i + share * facet.velocity_j;
    CHECK(norm(interpolated - wall_velocity(facet)) < 1e-12);
  }
}

TEST_CASE("the motion of a step is the contact velocity times the step, to second order") {
  RandomNumbers random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const MovingFacet facet = random_facet(random);
    const Vector velocity = contact_velocity(facet, wall_velocity(facet));
    const auto defect = [&](double time_step) {
      const ContactMotion motion = step_motion(facet, time_step);
      return Vector{motion.opening / time_step - dot(velocity, facet.normal()),
                    motion.slip_increment / time_step - dot(velocity, tangent(facet.normal()))};
    };
    CHECK(norm(defect(1e-3)) < 1e-4);
    // Second order: a tenth of the step, a hundredth of the defect.
    CHECK(norm(defect(1e-4)) < 0.011 * norm(defect(1e-3)) + 1e-10);
  }
}

TEST_CASE("where both nodes have the same transverse velocity, and Eqs (8) and (10) divide by zero, all is well") {
  MovingFacet facet{{0.0, 0.0}, {1.0, 0.0}, {0.2, 3.0}, {0.4, 3.0}, {0.25, -0.5}, {1.0, 2.0}, 0.7};
  CHECK_FALSE(std::isfinite(wall_velocity(facet).y));
  const ContactMotion motion = step_motion(facet, 1e-6);
  CHECK(motion.opening / 1e-6 == doctest::Approx(1.0).epsilon(1e-9));
  // Along tangent(n) = -axial: the facet moves at -0.25, the disc at -(1 - 0.7 · 0.5).
  CHECK(motion.slip_increment / 1e-6 == doctest::Approx(-0.25 + 0.65).epsilon(1e-5));
}
