#include <doctest/doctest.h>

#include <cmath>

#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr int n_discs = 20;
constexpr double radius = 0.05;
constexpr double spacing = 2.0 * radius;

/// Discs in a row, free at both ends.
Simulation chain() {
  Model model = empty_model();
  for (int i = 0; i < n_discs; ++i) add_particle(model, {spacing * i, 0.0}, radius);
  return make_simulation(std::move(model));
}

/// The shape of mode j of a free chain.
double shape(int mode, int disc) { return std::cos(std::numbers::pi * mode * (disc + 0.5) / n_discs); }

}  // namespace

TEST_CASE("every mode of a chain swings with ω = 2 √(k/m) sin(j π / 2N), up to ω_max = 2 √(k/m)") {
  constexpr double speed = 1e-6;
  for (const int mode : {1, 2, 7, n_discs - 1}) {
    CAPTURE(mode);
    Simulation simulation = chain();
    const double k_n = simulation.state().particle_contacts.normal_stiffness[0];
    const double mass = simulation.model().particles.real_mass[0];
    const double omega = 2.0 * std::sqrt(k_n / mass) * std::sin(0.5 * std::numbers::pi * mode / n_discs);
    for (Index i = 0; i < n_discs; ++i) set_velocity(simulation, i, {speed * shape(mode, i), 0.0});
    const double time_step = simulation.state().clock.time_step;
    const double angle = 2.0 * std::asin(0.5 * omega * time_step);
    const double amplitude = speed * time_step / std::sin(angle);
    double largest_error = 0.0;
    for (int step = 1; step <= 400; ++step) {
      simulation.step();
      for (Index i = 0; i < n_discs; ++i) {
        const double expected = amplitude * shape(mode, i) * std::sin(step * angle);
        largest_error =
            std::max(largest_error, std::abs(simulation.state().particles.translation.displacement[i].x - expected));
      }
    }
    CHECK(largest_error < 1e-11 * amplitude);
  }
}

TEST_CASE("a blow at one end arrives at the other at c = a √(k/m), a little late") {
  Simulation simulation = chain();
  const double k_n = simulation.state().particle_contacts.normal_stiffness[0];
  const double mass = simulation.model().particles.real_mass[0];
  set_velocity(simulation, 0, {1e-6, 0.0});
  double arrival = 0.0;
  double fastest = 0.0;
  const double travel_time = (n_discs - 1) / std::sqrt(k_n / mass);
  while (simulation.state().clock.time < 1.5 * travel_time) {
    simulation.step();
    const double speed = simulation.state().particles.translation.velocity[n_discs - 1].x;
    if (speed > fastest) {
      fastest = speed;
      arrival = simulation.state().clock.time;
    }
  }
  // The front of a dispersive chain: the peak of an Airy function lags by about N^(1/3).
  CHECK(arrival > travel_time);
  CHECK(arrival < travel_time * (1.0 + 2.0 * std::pow(n_discs, -2.0 / 3.0)));
}
