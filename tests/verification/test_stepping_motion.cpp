#include <doctest/doctest.h>

#include <cmath>

#include "support/bar_model.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// One free disc and a time step, since nothing has stiffness.
Simulation single_disc(double time_step, SimulationChoice choice) {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  choice.time_step = {.masses = Masses::real, .time_step = time_step};
  return make_simulation(std::move(model), std::move(choice));
}

void run(Simulation& simulation, int n_steps) {
  for (int i = 0; i < n_steps; ++i) simulation.step();
}

}  // namespace

TEST_CASE("free fall: x = ½ g t (t + Δt), the parabola whose top lies half a step before the start") {
  SimulationChoice choice;
  choice.gravity = Vector{0.5, -9.81};
  const double time_step = 1e-3;
  Simulation simulation = single_disc(time_step, std::move(choice));
  run(simulation, 1000);
  const double path = 0.5 * 1.0 * (1.0 + time_step);
  CHECK(simulation.state().clock.step == 1000);
  CHECK(simulation.state().clock.time == doctest::Approx(1.0).epsilon(1e-13));
  const Vector& fallen = simulation.state().particles.translation.displacement[0];
  CHECK(fallen.x == doctest::Approx(0.5 * path).epsilon(1e-13));
  CHECK(fallen.y == doctest::Approx(-9.81 * path).epsilon(1e-13));
  CHECK(simulation.audit() < 1e-13);
}

TEST_CASE("a moment turns a disc with M / ½ m R²") {
  SimulationChoice choice;
  choice.loads = {{.body = PointLoad::Body::particle, .row = 0, .moment = 4.0}};
  const double time_step = 1e-2;
  Simulation simulation = single_disc(time_step, std::move(choice));
  run(simulation, 100);
  const double inertia = 0.5 * simulation.model().particles.real_mass[0] * 0.25;
  CHECK(simulation.state().particles.rotation.rotation[0] ==
        doctest::Approx(4.0 / inertia * 0.5 * (1.0 + time_step)).epsilon(1e-13));
  CHECK(simulation.audit() < 1e-13);
}

TEST_CASE("a load that rises linearly moves a free body with the cube of the time") {
  const double rise_time = 1.0;
  SimulationChoice choice;
  choice.loads = {{.body = PointLoad::Body::particle, .row = 0, .force = {3.0, 0.0}, .rise_time = rise_time}};
  const double time_step = 1e-3;
  Simulation simulation = single_disc(time_step, std::move(choice));
  const double mass = simulation.model().particles.real_mass[0];
  run(simulation, 1000);
  // The sum over the steps of F n/N (N - n), exactly: t (t² - Δt²)/6 … by Σ n (N - n) = N (N² - 1)/6.
  const double exact = 3.0 / mass / rise_time * (1.0 - time_step * time_step) / 6.0;
  CHECK(simulation.state().particles.translation.displacement[0].x == doctest::Approx(exact).epsilon(1e-12));
  const double velocity = simulation.state().particles.translation.velocity[0].x;
  run(simulation, 500);
  // Constant from then on.
  CHECK(simulation.state().particles.translation.velocity[0].x ==
        doctest::Approx(velocity + 0.5 * 3.0 / mass).epsilon(1e-12));
  CHECK(simulation.audit() < 1e-13);
}

TEST_CASE("prescribed velocities are kept to the step, rise, stop, and their work becomes energy") {
  Model model = bar_model(20, 1.0);
  const auto left = section(model, 0);
  const auto right = last_section(model);
  SimulationChoice choice;
  for (const Index node : left) {
    choice.prescribed.push_back(
        {.row = node, .axis = 0, .motions = {{.velocity = 0.1, .rise_time = 0.25, .stop_time = 0.75}}});
  }
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  const TranslationState& nodes = simulation.state().nodes.translation;
  while (simulation.state().clock.time < 3.0) {
    simulation.step();
    const Clock& clock = simulation.state().clock;
    const double middle = clock.time + 0.5 * clock.time_step;
    const double expected = middle >= 0.75 ? 0.0 : 0.1 * std::min(1.0, middle / 0.25);
    REQUIRE(nodes.velocity[left[0]].x == expected);
    REQUIRE(simulation.audit() < 1e-12);
  }
  // 0.1 · (½ · 0.25 + 0.5); the ends of rise and stop are met within half a step.
  const double half_step = 0.5 * simulation.state().clock.time_step;
  CHECK(std::abs(nodes.displacement[left[0]].x - 0.0625) <= 0.1 * half_step);
  CHECK(simulation.state().ledger.total("prescribed_motions") > 0.0);
  CHECK(nodes.displacement[right[0]].x > 0.0);
}

TEST_CASE("a schedule is kept to rounding at every step, and the work of its cycles becomes energy") {
  Model model = bar_model(20, 1.0);
  const auto left = section(model, 0);
  const PiecewiseLinear schedule{{0.0, 0.3, 0.5, 0.9, 1.3}, {0.0, 0.01, 0.01, -0.02, 0.0}};
  SimulationChoice choice;
  for (const Index node : left) {
    choice.prescribed.push_back({.row = node, .axis = 0, .motions = {{.schedule = schedule}}});
  }
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  while (simulation.state().clock.time < 2.0) {
    simulation.step();
    const double wanted = schedule.value(simulation.state().clock.time);
    REQUIRE(std::abs(simulation.state().nodes.translation.displacement[left[0]].x - wanted) < 1e-15);
    REQUIRE(simulation.audit() < 1e-12);
  }
  CHECK(simulation.state().ledger.total("prescribed_motions") > 0.0);
}

TEST_CASE("a prescribed spin turns a free disc, and its work is the energy of the rotation") {
  SimulationChoice choice;
  choice.prescribed = {
      {.body = PrescribedFreedom::Body::particle, .row = 0, .axis = dimension, .motions = {{.velocity = 2.0}}}};
  Simulation simulation = single_disc(1e-2, std::move(choice));
  run(simulation, 100);
  CHECK(simulation.state().particles.rotation.rotation[0] == doctest::Approx(2.0).epsilon(1e-13));
  const double inertia = 0.5 * simulation.model().particles.real_mass[0] * 0.25;
  // From rest at -½ Δt to 2 rad/s: all of ½ I ω².
  CHECK(simulation.state().ledger.total("prescribed_motions") == doctest::Approx(0.5 * inertia * 4.0).epsilon(1e-13));
}

TEST_CASE("reactions of a held bar at rest balance its load and free axes have none") {
  Model model = bar_model(4, 1.0);
  const auto left = section(model, 0);
  hold(model, left);
  SimulationChoice choice;
  choice.loads = pull(last_section(model), 3.0, 200.0);
  choice.time_step.factor = 0.9;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  const auto reaction_at = [&](Index node) {
    const State& state = simulation.state();
    return reaction(state.nodes.translation, simulation.model().nodes.free, state.clock, node);
  };
  while (simulation.state().clock.time < 200.0) simulation.step();
  // What is left are oscillations of the period over the rise time.
  CHECK(reaction_at(left[0]).x + reaction_at(left[1]).x == doctest::Approx(-3.0).epsilon(0.01));
  CHECK(reaction_at(2).x == 0.0);
}
