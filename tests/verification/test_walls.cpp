#include <doctest/doctest.h>

#include <cmath>

#include "support/energy_drift.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr double friction = 0.3;

/// A disc above a floor, or as deep in it as `overlap` at set-up.
Model disc_on_floor(const WallChoice& wall, double overlap = 0.0) {
  Model model = empty_model({.interface_gap = 0.0});
  add_particle(model, {0.0, radius - overlap}, radius);
  add_wall(model, {50.0, 0.0}, {-50.0, 0.0}, wall);
  return model;
}

/// What holds or drives a wall (N).
Vector wall_reaction(const Simulation& simulation, std::size_t wall = 0) {
  const Model& model = simulation.model();
  Vector sum;
  for (const Index node : model.wall_nodes(wall)) {
    sum += reaction(simulation.state().nodes.translation, model.nodes.free, simulation.state().clock, node);
  }
  return sum;
}

}  // namespace

TEST_CASE("a wall that is pressed into a held disc gives k_n u, and its work is what the contact stores") {
  constexpr double speed = 1e-3;
  for (const bool is_tied : {false, true}) {
    CAPTURE(is_tied);
    Model model = disc_on_floor({.is_tied = is_tied}, 0.01 * radius);
    SimulationChoice choice;
    choice.prescribed = moved_wall(model, 0, {0.0, speed});
    for (const PrescribedFreedom& freedom : held_particle(0)) choice.prescribed.push_back(freedom);
    Simulation simulation = make_simulation(std::move(model), std::move(choice));
    // The overlap of set-up is the reference: it makes no force.
    CHECK(simulation.state().facet_contacts.normal_force[0] == 0.0);
    const double k_n = simulation.state().facet_contacts.normal_stiffness[0];
    for (int step = 0; step < 100; ++step) simulation.step();
    const double travel = speed * simulation.state().clock.time;
    CHECK(simulation.state().facet_contacts.normal_force[0] == doctest::Approx(k_n * travel).epsilon(1e-12));
    CHECK(wall_reaction(simulation).y == doctest::Approx(k_n * travel).epsilon(1e-9));
    CHECK(energy(simulation, "elastic_interface") == doctest::Approx(0.5 * k_n * travel * travel).epsilon(1e-12));
    CHECK(energy(simulation, "prescribed_motions") == doctest::Approx(0.5 * k_n * travel * travel).epsilon(1e-12));
  }
}

TEST_CASE("a wall that is drawn away pulls what is tied to it, and leaves behind what only touches") {
  constexpr double speed = -1e-3;
  for (const bool is_tied : {false, true}) {
    CAPTURE(is_tied);
    Model model = disc_on_floor({.is_tied = is_tied});
    SimulationChoice choice;
    choice.prescribed = moved_wall(model, 0, {0.0, speed});
    for (const PrescribedFreedom& freedom : held_particle(0)) choice.prescribed.push_back(freedom);
    Simulation simulation = make_simulation(std::move(model), std::move(choice));
    const double k_n = simulation.state().facet_contacts.normal_stiffness[0];
    for (int step = 0; step < 50; ++step) simulation.step();
    const double travel = speed * simulation.state().clock.time;
    CHECK(simulation.state().facet_contacts.normal_force[0] ==
          doctest::Approx(is_tied ? k_n * travel : 0.0).epsilon(1e-12));
  }
}

TEST_CASE("a tie leaves the disc free along the wall") {
  Model model = disc_on_floor({.is_tied = true});
  SimulationChoice choice;
  choice.prescribed = moved_wall(model, 0, {0.2, 0.0});
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  for (int step = 0; step < 200; ++step) simulation.step();
  CHECK(simulation.state().particles.translation.displacement[0] == Vector{});
  CHECK(simulation.state().particles.rotation.rotation[0] == 0.0);
}

TEST_CASE("a moving floor takes a disc along: it rolls at a third of the speed from t = v / (3 μ g) on") {
  constexpr double speed = 0.5;
  constexpr double gravity = 9.81;
  Model model = disc_on_floor({.friction_coefficient = friction});
  SimulationChoice choice;
  choice.gravity = Vector{0.0, -gravity};
  choice.prescribed = moved_wall(model, 0, {speed, 0.0});
  choice.time_step.factor = 0.02;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  const double mass = simulation.model().particles.real_mass[0];
  const double k_n = simulation.state().facet_contacts.normal_stiffness[0];
  set_displacement(simulation, 0, {0.0, -mass * gravity / k_n});
  simulation.step();
  EnergyDrift drift(simulation);
  const double begin_of_rolling = speed / (3.0 * friction * gravity);
  while (simulation.state().clock.time < 0.5 * begin_of_rolling) simulation.step();
  CHECK(simulation.state().particles.translation.velocity[0].x ==
        doctest::Approx(friction * gravity * simulation.state().clock.time).epsilon(1e-3));
  while (simulation.state().clock.time < 1.5 * begin_of_rolling) {
    simulation.step();
    drift.measure(simulation);
  }
  const double velocity = simulation.state().particles.translation.velocity[0].x;
  const double spin = simulation.state().particles.rotation.spin[0];
  CHECK(velocity == doctest::Approx(speed / 3.0).epsilon(2e-3));
  CHECK(velocity + spin * radius == doctest::Approx(speed).epsilon(2e-3));
  CHECK(drift.largest() < 1e-6);
}

TEST_CASE("a disc thrown at a wall is found, bounces back as fast up to the step, and is lost again") {
  Model model = disc_on_floor({});
  model.particles.position[0].y = 2.0 * radius;
  SimulationChoice choice{.skin = 0.01 * radius};
  choice.time_step = {.masses = Masses::real, .time_step = 2e-6};
  for (const PrescribedFreedom& freedom : moved_wall(model, 0, {})) choice.prescribed.push_back(freedom);
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  CHECK(simulation.state().facet_contacts.size() == 0);
  set_velocity(simulation, 0, {0.0, -1.0});
  while (simulation.state().clock.time < 3.0 * radius) simulation.step();
  CHECK(simulation.state().facet_contacts.size() == 0);
  CHECK(simulation.state().search.n_updates > 10);
  CHECK(simulation.state().particles.translation.velocity[0].y == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("a wall weighs nothing and sets no time step") {
  Model with = disc_on_floor({});
  SimulationChoice choice;
  choice.gravity = Vector{0.0, -9.81};
  choice.prescribed = moved_wall(with, 0, {});
  choice.time_step.factor = 0.9;
  const Simulation simulation = make_simulation(std::move(with), std::move(choice));
  CHECK(norm(wall_reaction(simulation)) == 0.0);
  CHECK(simulation.limiting_body() == "rotation of particle 1");
}
