#include <doctest/doctest.h>

#include <cmath>

#include "support/energy_drift.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr double speed = 1e-6;

/// Central differences make a sine of an oscillator, exactly: x_n = A sin(n θ), sin(θ/2) = ω Δt/2.
struct DiscreteSine {
  double angle = 0.0;
  double amplitude = 0.0;

  DiscreteSine(double omega, double time_step, double start_speed)
      : angle(2.0 * std::asin(0.5 * omega * time_step)), amplitude(start_speed * time_step / std::sin(angle)) {}
  [[nodiscard]] double at(int step) const { return amplitude * std::sin(step * angle); }
};

/// Follows a motion for three periods and compares it with the sine; the period agrees with 2π/ω to Δt².
template <class Measure>
void check_oscillation(Simulation& simulation, double omega, Measure&& measure) {
  const double time_step = simulation.state().clock.time_step;
  const DiscreteSine sine(omega, time_step, speed);
  CHECK(2.0 * std::numbers::pi / sine.angle * time_step ==
        doctest::Approx(2.0 * std::numbers::pi / omega).epsilon(omega * omega * time_step * time_step / 20.0));
  EnergyDrift drift(simulation);
  double largest_error = 0.0;
  const int n_steps = static_cast<int>(6.0 * std::numbers::pi / sine.angle);
  for (int step = 1; step <= n_steps; ++step) {
    simulation.step();
    largest_error = std::max(largest_error, std::abs(measure(simulation.state()) - sine.at(step)));
    drift.measure(simulation);
  }
  CHECK(drift.largest() < 1e-13);
  CHECK(largest_error < 1e-12 * sine.amplitude);
}

Model two_discs() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, radius);
  add_particle(model, {0.18 * 0.8, 0.18 * 0.6}, radius);
  return model;
}

/// A disc that touches a facet of held nodes, solid below.
Model disc_on_wall(std::vector<PrescribedFreedom>& supports) {
  Model model = empty_model();
  add_node(model, {1.0, 0.0});
  add_node(model, {-1.0, 0.0});
  add_facet(model, 0, 1);
  add_particle(model, {0.3, radius}, radius);
  for (const Index node : {0, 1}) {
    for (const PrescribedFreedom& freedom : held_node(node)) supports.push_back(freedom);
  }
  return model;
}

}  // namespace

TEST_CASE("two free discs oscillate with T = 2π √(m / 2 k_n)") {
  Simulation simulation = make_simulation(two_discs());
  const double k_n = simulation.state().particle_contacts.normal_stiffness[0];
  const double mass = simulation.model().particles.real_mass[0];
  const Vector axis{0.8, 0.6};
  set_velocity(simulation, 0, -speed * axis);
  set_velocity(simulation, 1, speed * axis);
  check_oscillation(simulation, std::sqrt(2.0 * k_n / mass),
                    [&](const State& state) { return dot(state.particles.translation.displacement[1], axis); });
}

TEST_CASE("a disc on one that is held oscillates with T = 2π √(m / k_n)") {
  Simulation simulation = make_simulation(two_discs(), {.prescribed = held_particle(0)});
  const double k_n = simulation.state().particle_contacts.normal_stiffness[0];
  const double mass = simulation.model().particles.real_mass[1];
  const Vector axis{0.8, 0.6};
  set_velocity(simulation, 1, speed * axis);
  check_oscillation(simulation, std::sqrt(k_n / mass),
                    [&](const State& state) { return dot(state.particles.translation.displacement[1], axis); });
}

TEST_CASE("a disc bonded to a wall oscillates along the normal with ω² = k_n / m") {
  SimulationChoice choice;
  Model model = disc_on_wall(choice.prescribed);
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  const double k_n = simulation.state().facet_contacts.normal_stiffness[0];
  set_velocity(simulation, 0, {0.0, speed});
  check_oscillation(simulation, std::sqrt(k_n / simulation.model().particles.real_mass[0]),
                    [](const State& state) { return state.particles.translation.displacement[0].y; });
}

TEST_CASE("a disc bonded to a wall oscillates along it with ω² = 3 k_s / m") {
  SimulationChoice choice;
  Model model = disc_on_wall(choice.prescribed);
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  const double k_s = simulation.state().facet_contacts.shear_stiffness[0];
  // The other motion of the two freedoms is rolling, without any force: the spin must not excite it.
  set_velocity(simulation, 0, {speed, 0.0}, 2.0 * speed / radius);
  check_oscillation(simulation, std::sqrt(3.0 * k_s / simulation.model().particles.real_mass[0]),
                    [](const State& state) { return state.particles.translation.displacement[0].x; });
}

TEST_CASE("a bonded disc rolls on a wall without any force") {
  SimulationChoice choice;
  Model model = disc_on_wall(choice.prescribed);
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  set_velocity(simulation, 0, {0.1, 0.0}, -0.1 / radius);
  for (int step = 0; step < 500; ++step) simulation.step();
  const State& state = simulation.state();
  CHECK(state.particles.translation.displacement[0].x == doctest::Approx(0.1 * state.clock.time).epsilon(1e-9));
  CHECK(std::abs(state.facet_contacts.shear_force[0]) < 1e-3);
}
