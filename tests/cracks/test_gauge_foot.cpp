#include <doctest/doctest.h>

#include "build/gauge_foot.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Discs of several sizes left and right of a crack along x = 0.
Model discs_along_a_crack() {
  Model model = empty_model();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (const double side : {-1.0, 1.0}) {
        add_particle(model, {side * (0.5 + 0.9 * i), 1.1 * j}, 0.2 + 0.05 * ((3 * i + 5 * j) % 4));
      }
    }
  }
  return model;
}

double displacement(const std::vector<WatchedBody>& bodies, const State& state) {
  double sum = 0.0;
  for (const WatchedBody& body : bodies) sum += body.weight * body.displacement(state);
  return sum;
}

double sum_of_weights(const std::vector<WatchedBody>& bodies) {
  double sum = 0.0;
  for (const WatchedBody& body : bodies) sum += body.weight;
  return sum;
}

}  // namespace

TEST_CASE("a place moves with the particles under a foot as with one rigid body, each side of a crack with its own") {
  const Model model = discs_along_a_crack();
  State state = resting_state(model);
  // Each side turns about a centre of its own, by a small angle.
  const auto motion = [](const Vector& at) {
    return at.x < 0.0 ? Vector{1e-3, 2e-3} + cross(Spin{3e-3}, at) : Vector{-4e-3, 5e-3} + cross(Spin{-7e-3}, at);
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    state.particles.translation.displacement[i] = motion(model.particles.position[i]);
  }
  const Vector left{-0.01, 0.3};
  const Vector right{0.01, 0.3};
  for (const int axis : {0, 1}) {
    const auto from = bodies_under_foot(model, left, right, 4.0, axis);
    const auto to = bodies_under_foot(model, right, left, 4.0, axis);
    CHECK(from.size() > 8);
    CHECK(sum_of_weights(from) == doctest::Approx(1.0));
    CHECK(displacement(from, state) == doctest::Approx(component(motion(left), axis)).epsilon(1e-12));
    CHECK(displacement(to, state) == doctest::Approx(component(motion(right), axis)).epsilon(1e-12));
  }
}

TEST_CASE("a small particle that hangs loose counts by its area") {
  Model model = empty_model();
  add_particle(model, {-1.0, 1.0}, 0.5);
  add_particle(model, {-1.0, -1.0}, 0.5);
  add_particle(model, {-1.0, 0.0}, 0.05);
  State state = resting_state(model);
  state.particles.translation.displacement[2] = {0.0, 1.0};
  const auto bodies = bodies_under_foot(model, {-1.0, 0.0}, {1.0, 0.0}, 3.0, 1);
  CHECK(displacement(bodies, state) == doctest::Approx(0.0025 / (0.25 + 0.25 + 0.0025)));
}

TEST_CASE(
    "under a foot that stands on nothing there are no bodies, and one particle carries the place without turning it") {
  Model model = empty_model();
  CHECK(bodies_under_foot(model, {0.0, 0.0}, {1.0, 0.0}, 1.0, 0).empty());
  add_particle(model, {-0.3, 0.2}, 0.1);
  const auto bodies = bodies_under_foot(model, {0.0, 0.0}, {1.0, 0.0}, 1.0, 0);
  State state = resting_state(model);
  state.particles.translation.displacement[0] = {3.0, 4.0};
  CHECK(displacement(bodies, state) == doctest::Approx(3.0));
}
