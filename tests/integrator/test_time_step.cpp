#include <doctest/doctest.h>

#include <cmath>

#include "integrator/time_step.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Two discs of radius ½ and ¼, two nodes.
Model bodies() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  add_particle(model, {1.0, 0.0}, 0.25);
  add_node(model, {2.0, 0.0});
  add_node(model, {3.0, 0.0});
  return model;
}

StiffnessBounds bounds_of_bodies() {
  StiffnessBounds bounds(2, 2);
  bounds.particle_translation = {100.0, 200.0};
  bounds.particle_rotation = {50.0, 80.0};
  bounds.node_translation = {40.0, 0.0};
  return bounds;
}

}  // namespace

TEST_CASE("the critical time step is 2/ω of the body with the largest bound over mass") {
  const Model model = bodies();
  State state = resting_state(model);
  state.particles.translation.mass = {1.0, 4.0};
  state.particles.rotation.inertia = {1.0, 1.0};
  state.nodes.translation.mass = {4.0, 1e-9};
  CriticalTimeStep critical = critical_time_step(model, state, bounds_of_bodies());
  CHECK(critical.time_step == doctest::Approx(2.0 / std::sqrt(100.0)));
  CHECK(critical.limiting_body == "particle 1");

  // A bound of 80 N/m on θ' = R θ is 80 R² N m on θ.
  state.particles.rotation.inertia[1] = 0.01;
  critical = critical_time_step(model, state, bounds_of_bodies());
  CHECK(critical.time_step == doctest::Approx(2.0 / std::sqrt(80.0 * 0.0625 / 0.01)));
  CHECK(critical.limiting_body == "rotation of particle 2");

  state.nodes.translation.mass[0] = 0.04;
  critical = critical_time_step(model, state, bounds_of_bodies());
  CHECK(critical.time_step == doctest::Approx(2.0 / std::sqrt(1000.0)));
  CHECK(critical.limiting_body == "node 1");
}

TEST_CASE("without stiffness any time step is stable") {
  const Model model = bodies();
  const CriticalTimeStep critical = critical_time_step(model, resting_state(model), StiffnessBounds(2, 2));
  CHECK(std::isinf(critical.time_step));
  CHECK(critical.limiting_body == "none");
}

TEST_CASE("real masses are those of the model, I = ½ m R²") {
  Model model = bodies();
  model.nodes.real_mass = {3.0, 5.0};
  State state = resting_state(model);
  use_real_masses(model, state);
  CHECK(state.particles.translation.mass == model.particles.real_mass);
  CHECK(state.nodes.translation.mass == model.nodes.real_mass);
  CHECK(state.particles.rotation.inertia[1] == doctest::Approx(0.5 * model.particles.real_mass[1] * 0.0625));
}

TEST_CASE("scaled masses make every body equally fast and what feels no stiffness gets the mean") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = 0.2;
  use_scaled_masses(model, state, bounds_of_bodies(), 1.21);
  CHECK(state.particles.translation.mass[0] == doctest::Approx(0.01 * 1.21 * 100.0));
  CHECK(state.particles.translation.mass[1] == doctest::Approx(0.01 * 1.21 * 200.0));
  CHECK(state.particles.rotation.inertia[0] == doctest::Approx(0.01 * 1.21 * 50.0 * 0.25));
  CHECK(state.nodes.translation.mass[0] == doctest::Approx(0.01 * 1.21 * 40.0));
  CHECK(state.nodes.translation.mass[1] == doctest::Approx(0.01 * 1.21 * 40.0));
  CHECK(critical_time_step(model, state, bounds_of_bodies()).time_step == doctest::Approx(0.2 * 1.1));
}

TEST_CASE("masses are raised only where even those without safety would not do, and never lowered") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = 2.0;
  use_scaled_masses(model, state, bounds_of_bodies(), 1.1);
  state.particles.translation.velocity = {{3.0, 4.0}, {1.0, 0.0}};
  state.particles.rotation.spin = {0.0, 2.0};
  const State before = state;

  StiffnessBounds bounds = bounds_of_bodies();
  bounds.particle_translation = {105.0, 20.0};
  CHECK(raise_scaled_masses(model, state, bounds, 1.1) == 0.0);
  CHECK(state.particles.translation.mass == before.particles.translation.mass);

  bounds.particle_translation[0] = 120.0;
  bounds.particle_rotation[1] = 160.0;
  const double energy = raise_scaled_masses(model, state, bounds, 1.1);
  CHECK(state.particles.translation.mass[0] == doctest::Approx(1.1 * 120.0));
  CHECK(state.particles.translation.mass[1] == before.particles.translation.mass[1]);
  CHECK(state.particles.rotation.inertia[1] == doctest::Approx(1.1 * 160.0 * 0.0625));
  CHECK(energy == doctest::Approx(0.5 * 1.1 * 20.0 * 25.0 + 0.5 * 1.1 * 80.0 * 0.0625 * 4.0));
  CHECK(state.particles.translation.velocity == before.particles.translation.velocity);
}
