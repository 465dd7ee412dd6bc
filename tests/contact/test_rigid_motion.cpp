#include <doctest/doctest.h>

#include <cmath>

#include "support/random_numbers.hpp"
#include "support/three_kinds_of_contact.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Largest opening and slip so far of any contact, over the radius.
double largest_strain(const ThreeKindsOfContact& bodies) {
  double largest = 0.0;
  for (const ContactTable* contacts : bodies.tables()) {
    for (std::size_t row = 0; row < contacts->size(); ++row) {
      largest = std::max({largest, std::abs(contacts->opening[row]), std::abs(contacts->shear_displacement[row])});
    }
  }
  return largest / bodies.radius;
}

/// Largest force on any body over k_n R.
double largest_force(const ThreeKindsOfContact& bodies) {
  double largest = 0.0;
  for (const Vector& force : bodies.state.particles.translation.force) largest = std::max(largest, norm(force));
  for (const Vector& force : bodies.state.nodes.translation.force) largest = std::max(largest, norm(force));
  for (const Moment moment : bodies.state.particles.rotation.moment) {
    largest = std::max(largest, std::abs(moment) / bodies.radius);
  }
  return largest / (bodies.state.facet_contacts.normal_stiffness[0] * bodies.radius);
}

}  // namespace

TEST_CASE("bodies in touch at set-up are bonded, one contact of each kind") {
  const ThreeKindsOfContact bodies;
  for (const ContactTable* contacts : bodies.tables()) {
    REQUIRE(contacts->size() == 1);
    CHECK(contacts->bond[0] == BondState::bonded);
    CHECK(contacts->law[0] == bond_law);
  }
  CHECK(bodies.state.facet_contacts.second[0] == 1);
  CHECK(bodies.state.corner_contacts.second[0] == 2);
}

TEST_CASE("a rigid motion in one step, however large, makes no opening, slip or force") {
  for (const double angle : {0.0, 1e-9, 1e-3, 0.5, 1.5, -1.5, 2.5, -3.0, 3.1}) {
    CAPTURE(angle);
    ThreeKindsOfContact bodies;
    move_rigidly(bodies.model, bodies.state, {{0.3, -0.7}, angle, {2.0, -1.0}});
    bodies.add_forces();
    CHECK(largest_strain(bodies) < 3e-14);
    CHECK(largest_force(bodies) < 3e-14);
  }
}

TEST_CASE("a rigid motion in many steps makes no opening, slip or force") {
  ThreeKindsOfContact bodies;
  RandomNumbers random(1);
  RigidMotion motion{{0.3, -0.7}, 0.0, {}};
  for (int step = 0; step < 2000; ++step) {
    motion.angle += random.uniform(-0.5, 1.0);
    motion.shift += random.vector(0.2);
    move_rigidly(bodies.model, bodies.state, motion);
    bodies.add_forces();
  }
  CHECK(motion.angle > 300.0);
  // Openings are total: no error adds up; slips are sums of 2000 roundings.
  CHECK(largest_strain(bodies) < 2e-11);
  CHECK(largest_force(bodies) < 2e-11);
}

TEST_CASE("a rigid motion far from the origin makes no force") {
  ThreeKindsOfContact bodies({1000.0, -2000.0});
  move_rigidly(bodies.model, bodies.state, {{1000.0, -2000.0}, 1.0, {0.1, 0.2}});
  bodies.add_forces();
  // Places at rest are rounded to 1e-13 m, but their differences are exact.
  CHECK(largest_force(bodies) < 1e-13);
}

TEST_CASE("rigid steps after a deformation carry the contact forces along") {
  ThreeKindsOfContact bodies;
  RandomNumbers random(2);
  for (std::size_t i = 0; i < bodies.model.particles.size(); ++i) {
    displace(bodies.state.particles.translation, i, random.vector(1e-3));
    rotate(bodies.state.particles.rotation, i, random.uniform(-1e-3, 1e-3));
  }
  bodies.add_forces();
  const State before = bodies.state;
  const double angle = 1.2;
  // Every body moves as the rotation about the origin moves its place now.
  const auto turn = [&](TranslationState& moving, const Field<Vector>& rest) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const Vector place = rest[i] + moving.displacement[i];
      displace(moving, i, moving.displacement[i] + RigidMotion{{}, angle, {}}.displacement(place));
    }
  };
  turn(bodies.state.particles.translation, bodies.model.particles.position);
  turn(bodies.state.nodes.translation, bodies.model.nodes.position);
  for (std::size_t i = 0; i < bodies.model.particles.size(); ++i) {
    rotate(bodies.state.particles.rotation, i, bodies.state.particles.rotation.rotation[i] + angle);
  }
  bodies.add_forces();
  const auto turned = [&](const Vector& force) { return force + RigidMotion{{}, angle, {}}.displacement(force); };
  const double scale = norm(before.particles.translation.force[0]);
  for (std::size_t i = 0; i < bodies.model.particles.size(); ++i) {
    const Vector expected = turned(before.particles.translation.force[i]);
    CHECK(norm(bodies.state.particles.translation.force[i] - expected) < 1e-10 * scale);
    CHECK(bodies.state.particles.rotation.moment[i] ==
          doctest::Approx(before.particles.rotation.moment[i]).epsilon(1e-9));
  }
  for (std::size_t i = 0; i < bodies.model.nodes.size(); ++i) {
    const Vector expected = turned(before.nodes.translation.force[i]);
    CHECK(norm(bodies.state.nodes.translation.force[i] - expected) < 1e-10 * scale);
  }
}
