#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "integrator/body_loops.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr std::size_t n_bodies = 101;
/// Of work (J): forces are below 10 N, velocities below 2 m/s.
constexpr double largest_rounding = 1e-15;

/// One freedom of a body.
struct Freedom {
  double force;
  double inertia;
  double free;
  double velocity;
};

/// The velocity after a step, as the law of motion reads.
double velocity_after(const Freedom& freedom, const MotionLaw& law) {
  const auto& [viscous, local] = law.damping;
  const double acceleration = freedom.force / freedom.inertia;
  const double factor = law.acceleration_time / (1.0 + 0.5 * viscous * law.acceleration_time);
  const double undragged = freedom.velocity + factor * (freedom.free * (acceleration - viscous * freedom.velocity));
  const double drag = factor * local * (freedom.free * std::abs(acceleration));
  return undragged - std::clamp(freedom.velocity + undragged, -drag, drag);
}

TranslationState random_translations(RandomNumbers& random) {
  TranslationState bodies;
  for (std::size_t i = 0; i < n_bodies; ++i) {
    bodies.force.push_back(random.vector(10.0));
    bodies.mass.push_back(random.uniform(0.5, 2.0));
    bodies.increment.push_back(random.vector(1e-3));
    bodies.velocity_before.push_back(random.vector(1.0));
    bodies.velocity.push_back({});
  }
  return bodies;
}

RotationState random_rotations(RandomNumbers& random) {
  RotationState bodies;
  for (std::size_t i = 0; i < n_bodies; ++i) {
    bodies.moment.push_back(random.uniform(-10.0, 10.0));
    bodies.inertia.push_back(random.uniform(0.5, 2.0));
    bodies.increment.push_back(random.uniform(-1e-3, 1e-3));
    bodies.spin_before.push_back(random.uniform(-1.0, 1.0));
    bodies.spin.push_back(0.0);
  }
  return bodies;
}

/// Every third body is held.
Field<double> random_freedom() {
  Field<double> free;
  for (std::size_t i = 0; i < n_bodies; ++i) free.push_back(i % 3 == 0 ? 0.0 : 1.0);
  return free;
}

Field<Vector> random_freedoms() {
  Field<Vector> free;
  for (std::size_t i = 0; i < n_bodies; ++i) free.push_back({i % 3 == 0 ? 0.0 : 1.0, i % 4 == 0 ? 0.0 : 1.0});
  return free;
}

constexpr DampingCoefficients dampings[] = {{0.0, 0.0}, {0.7, 0.0}, {0.0, 0.7}};

}  // namespace

TEST_CASE("translations: vector loops have the bits of the law of motion of each freedom") {
  RandomNumbers random(21);
  const Field<Vector> free = random_freedoms();
  for (const DampingCoefficients& damping : dampings) {
    const MotionLaw law{damping, 0.01, 0.008, 0.012};
    TranslationState bodies = random_translations(random);
    const TranslationState before = bodies;
    BlockTerms work;
    accelerate(bodies, free, law, {1, n_bodies}, work);
    CHECK(bodies.velocity[0] == before.velocity[0]);
    for (std::size_t i = 1; i < n_bodies; ++i) {
      double behind = 0.0;
      for (int axis = 0; axis < dimension; ++axis) {
        const Freedom freedom{component(before.force[i], axis), before.mass[i], component(free[i], axis),
                              component(before.velocity_before[i], axis)};
        const double after = velocity_after(freedom, law);
        REQUIRE(component(bodies.velocity[i], axis) == after);
        const double shown = freedom.inertia * (after - freedom.velocity) / law.acceleration_time;
        behind += 0.5 * freedom.free * (shown - freedom.force) * law.time_step_before * freedom.velocity;
      }
      REQUIRE(std::abs(work.first[i - 1] - behind) < largest_rounding);
    }
  }
}

TEST_CASE("rotations: vector loops have the bits of the law of motion of each freedom") {
  RandomNumbers random(22);
  const Field<double> free = random_freedom();
  for (const DampingCoefficients& damping : dampings) {
    const MotionLaw law{damping, 0.01, 0.008, 0.012};
    RotationState bodies = random_rotations(random);
    const RotationState before = bodies;
    BlockTerms work{};
    accelerate(bodies, free, law, {0, n_bodies}, work);
    for (std::size_t i = 0; i < n_bodies; ++i) {
      const Freedom freedom{before.moment[i], before.inertia[i], free[i], before.spin_before[i]};
      const double after = velocity_after(freedom, law);
      REQUIRE(bodies.spin[i] == after);
      const double shown = freedom.inertia * (after - freedom.velocity) / law.acceleration_time;
      const double ahead = 0.5 * law.time_step * freedom.free * (shown - freedom.force) * after;
      REQUIRE(std::abs(work.second[i] - ahead) < largest_rounding);
    }
  }
}

TEST_CASE("terms are summed by lanes, then over lanes") {
  RandomNumbers random(24);
  BlockTerms terms;
  std::array<TwoSums, BlockTerms::n_lanes> lanes;
  for (std::size_t i = 0; i < n_bodies; ++i) {
    terms.first[i] = random.uniform(-1.0, 1.0);
    terms.second[i] = random.uniform(-1.0, 1.0);
    lanes[i % BlockTerms::n_lanes] += {terms.first[i], terms.second[i]};
  }
  TwoSums expected;
  for (const TwoSums& lane : lanes) expected += lane;
  CHECK(terms.sum(n_bodies).first == expected.first);
  CHECK(terms.sum(n_bodies).second == expected.second);
}

TEST_CASE("terms of the Rayleigh quotient, and forces remembered") {
  RandomNumbers random(23);
  const TranslationState translation = random_translations(random);
  const RotationState rotation = random_rotations(random);
  const Field<Vector> free = random_freedoms();
  const Field<double> rotation_free = random_freedom();
  const Field<Vector> force_then = random_translations(random).force;
  const Field<Moment> moment_then = random_rotations(random).moment;
  Field<Vector> force_before = force_then;
  Field<Moment> moment_before = moment_then;
  BlockTerms terms;
  add_rayleigh_terms(translation, free, force_before, {0, n_bodies}, terms);
  add_rayleigh_terms(rotation, rotation_free, moment_before, {0, n_bodies}, terms);
  for (std::size_t i = 0; i < n_bodies; ++i) {
    const Vector x = componentwise(free[i], translation.increment[i]);
    const double turn = rotation_free[i] * rotation.increment[i];
    REQUIRE(terms.first[i] ==
            -dot(x, translation.force[i] - force_then[i]) - turn * (rotation.moment[i] - moment_then[i]));
    REQUIRE(terms.second[i] == translation.mass[i] * dot(x, x) + rotation.inertia[i] * turn * turn);
  }
  CHECK(force_before == translation.force);
  CHECK(moment_before == rotation.moment);
}
