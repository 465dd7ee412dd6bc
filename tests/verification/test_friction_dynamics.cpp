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
constexpr double gravity = 9.81;

/// A disc that just touches a long plane, not bonded, pressed by its weight and already in balance with it.
struct DiscOnPlane {
  Simulation simulation;
  double mass = 0.0;
  double weight = 0.0;  ///< its part against the plane (N)
  double k_n = 0.0;
  double k_s = 0.0;

  DiscOnPlane(bool can_turn, double slope)
      : simulation(make(can_turn, slope)),
        mass(simulation.model().particles.real_mass[0]),
        weight(mass * gravity * std::cos(slope)),
        k_n(simulation.state().facet_contacts.normal_stiffness[0]),
        k_s(simulation.state().facet_contacts.shear_stiffness[0]) {
    set_displacement(simulation, 0, {0.0, -weight / k_n - gap});
  }

  static constexpr double gap = 1e-9;
  static Simulation make(bool can_turn, double slope) {
    Model model = empty_model({.friction_coefficient = friction, .interface_gap = 0.0});
    add_node(model, {5.0, 0.0});
    add_node(model, {-5.0, 0.0});
    add_facet(model, 0, 1);
    add_particle(model, {0.0, radius + gap}, radius);
    SimulationChoice choice;
    choice.gravity = gravity * Vector{std::sin(slope), -std::cos(slope)};
    for (const Index node : {0, 1}) {
      for (const PrescribedFreedom& freedom : held_node(node)) choice.prescribed.push_back(freedom);
    }
    // Small against the stretch of the spring at which the disc begins to slide.
    choice.time_step.factor = 0.0125;
    if (!can_turn) choice.prescribed.push_back(held_particle(0)[2]);
    return make_simulation(std::move(model), std::move(choice));
  }
  [[nodiscard]] const State& state() const { return simulation.state(); }
  [[nodiscard]] Vector place() const { return state().particles.translation.displacement[0]; }
  [[nodiscard]] Vector velocity() const { return state().particles.translation.velocity[0]; }
};

}  // namespace

TEST_CASE("a sliding block stops after v² / (2 μ g), its kinetic energy spent in friction") {
  constexpr double speed = 1.0;
  DiscOnPlane block(false, 0.0);
  set_velocity(block.simulation, 0, {speed, 0.0});
  // The forces of the hand-made start are not known to the state before the first step.
  block.simulation.step();
  EnergyDrift drift(block.simulation);
  for (int step = 0; block.velocity().x > 0.0 && step < 1000000; ++step) {
    block.simulation.step();
    drift.measure(block.simulation);
  }
  const double distance = speed * speed / (2.0 * friction * gravity);
  const double stop = block.place().x;
  // The first step is free, and one step is how well the end is known.
  CHECK(std::abs(stop - distance) < speed * block.state().clock.time_step);
  CHECK(stop == doctest::Approx(distance).epsilon(1e-4));
  const double lost = 0.5 * block.mass * speed * speed;
  const double stretch = friction * block.weight / block.k_s;
  CHECK(energy(block.simulation, "friction") ==
        doctest::Approx(lost - 0.5 * friction * block.weight * stretch).epsilon(1e-6));
  // From there on the block swings by the stretch of the spring about its place, without friction.
  for (int step = 0; step < 2000; ++step) {
    block.simulation.step();
    drift.measure(block.simulation);
    REQUIRE(block.place().x < stop + 0.01 * stretch);
    REQUIRE(block.place().x > stop - 2.01 * stretch);
  }
  CHECK(energy(block.simulation, "friction") == doctest::Approx(lost).epsilon(1e-5));
  CHECK(drift.largest() < 1e-9);
}

TEST_CASE("a sliding disc rolls from t = v / (3 μ g) on, with two thirds of its speed") {
  constexpr double speed = 1.0;
  DiscOnPlane disc(true, 0.0);
  set_velocity(disc.simulation, 0, {speed, 0.0});
  const double rolling = speed / (3.0 * friction * gravity);
  const auto slip_speed = [&] { return disc.velocity().x + radius * disc.state().particles.rotation.spin[0]; };
  double start_of_rolling = 0.0;
  disc.simulation.step();
  EnergyDrift drift(disc.simulation);
  double mean_speed = 0.0;
  int n_rolling = 0;
  while (disc.state().clock.time < 1.5 * rolling) {
    disc.simulation.step();
    drift.measure(disc.simulation);
    if (start_of_rolling == 0.0 && slip_speed() <= 0.0) start_of_rolling = disc.state().clock.time;
    if (start_of_rolling == 0.0) continue;
    mean_speed += disc.velocity().x;
    ++n_rolling;
  }
  CHECK(start_of_rolling == doctest::Approx(rolling).epsilon(2e-3));
  CHECK(mean_speed / n_rolling == doctest::Approx(2.0 / 3.0 * speed).epsilon(1e-3));
  // A third of the kinetic energy is lost.
  CHECK(energy(disc.simulation, "friction") == doctest::Approx(0.5 * disc.mass * speed * speed / 3.0).epsilon(1e-3));
  CHECK(drift.largest() < 1e-9);
}

TEST_CASE("a block on a slope slides if, and only if, tan θ > μ") {
  constexpr double duration = 0.1;
  SUBCASE("a little below") {
    DiscOnPlane block(false, std::atan(0.99 * friction));
    const double stretch = friction * block.weight / block.k_s;
    while (block.state().clock.time < 0.5 * duration) block.simulation.step();
    const double half_time = block.place().x;
    // Set down with the spring unstretched it comes to the limit with 0.49 μN times the stretch of kinetic energy,
    // which a resistance of 0.01 μN takes 49 stretches to use up.
    CHECK(half_time < 60.0 * stretch);
    // Then it swings by a stretch to either side of the place where the spring holds it.
    while (block.state().clock.time < duration) block.simulation.step();
    CHECK(std::abs(block.place().x - half_time) < 2.1 * stretch);
  }
  SUBCASE("a little above") {
    const double slope = std::atan(1.05 * friction);
    DiscOnPlane block(false, slope);
    while (block.state().clock.time < duration) block.simulation.step();
    const double acceleration = gravity * (std::sin(slope) - friction * std::cos(slope));
    CHECK(block.place().x == doctest::Approx(0.5 * acceleration * duration * duration).epsilon(0.02));
  }
}
