#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "integrator/convergence.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Model bodies() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  add_particle(model, {1.0, 0.0}, 0.25);
  add_node(model, {2.0, 0.0});
  return model;
}

}  // namespace

TEST_CASE("the unbalance is the largest resultant over the mean internal force") {
  const Model model = bodies();
  State state = resting_state(model);
  state.particles.translation.force = {{3.0, -4.0}, {1.0, 0.0}};
  state.nodes.translation.force = {{0.0, 2.0}};
  const Unbalance unbalance = measure_unbalance(model, state, {.sum = 30.0, .count = 3.0});
  CHECK(unbalance.largest_resultant == 5.0);
  CHECK(unbalance.mean_force == 10.0);
  CHECK(unbalance.ratio() == 0.5);
}

TEST_CASE("moments count over the radius") {
  const Model model = bodies();
  State state = resting_state(model);
  state.particles.rotation.moment = {1.0, -1.0};
  CHECK(measure_unbalance(model, state, {1.0, 1.0}).largest_resultant == 4.0);
}

TEST_CASE("what is held is balanced by its reaction") {
  Model model = bodies();
  State state = resting_state(model);
  state.particles.translation.force = {{3.0, -4.0}, {0.0, 0.0}};
  state.particles.rotation.moment = {0.0, 7.0};
  state.nodes.translation.force = {{9.0, 2.0}};
  model.particles.free[0] = {0.0, 1.0};
  model.particles.rotation_free[1] = 0.0;
  model.nodes.free[0] = {};
  CHECK(measure_unbalance(model, state, {1.0, 1.0}).largest_resultant == 4.0);
}

TEST_CASE("while nothing carries force, nothing is at rest") {
  const Model model = bodies();
  CHECK(std::isinf(measure_unbalance(model, resting_state(model), {}).ratio()));
}

TEST_CASE("a force that is not a number is never balanced, wherever it acts") {
  const Model model = bodies();
  for (int place = 0; place < 4; ++place) {
    State state = resting_state(model);
    state.nodes.translation.force[0] = {1.0, 0.0};
    if (place == 0) state.particles.translation.force[0] = {not_a_number, 0.0};
    if (place == 1) state.particles.translation.force[1] = {0.0, not_a_number};
    if (place == 2) state.particles.rotation.moment[0] = not_a_number;
    if (place == 3) state.nodes.translation.force[0] = {not_a_number, not_a_number};
    CHECK(std::isinf(measure_unbalance(model, state, {1.0, 1.0}).ratio()));
  }
}
