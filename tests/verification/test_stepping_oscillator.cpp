#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/bar_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

// One element of length 1 held at the left: k = 1, m = ½.
constexpr double stiffness = 1.0;
const double frequency = std::sqrt(2.0);
constexpr double force = 3.0;

/// The oscillator under a force that acts from the start, with a time step of our own.
Simulation pulled_oscillator(double time_step) {
  Model model = bar_model(1, 1.0);
  hold(model, section(model, 0));
  SimulationChoice choice;
  // No contact detection, which would correct an unstable time step.
  choice.skin = std::numeric_limits<double>::max();
  choice.loads = pull(section(model, 1), force);
  choice.time_step = {.masses = Masses::real, .factor = 100.0, .time_step = time_step};
  return make_simulation(std::move(model), std::move(choice));
}

double displacement(const Simulation& simulation) { return simulation.state().nodes.translation.displacement[1].x; }

double largest_displacement(double time_step, int n_steps) {
  Simulation simulation = pulled_oscillator(time_step);
  double largest = 0.0;
  for (int i = 0; i < n_steps; ++i) {
    simulation.step();
    largest = std::max(largest, std::abs(displacement(simulation)));
  }
  return largest;
}

}  // namespace

TEST_CASE("an oscillator follows the exact solution of the difference equation") {
  for (const double share : {0.05, 0.5, 0.99}) {
    const double time_step = share * 2.0 / frequency;
    // sin(ω_d Δt/2) = ω Δt/2; v(-½) = 0 puts the turning point half a step before the start.
    const double half_angle = std::asin(0.5 * frequency * time_step);
    Simulation simulation = pulled_oscillator(time_step);
    double largest_error = 0.0;
    for (int n = 1; n <= 2000; ++n) {
      simulation.step();
      const double exact = force / stiffness * (1.0 - std::cos(half_angle * (2 * n + 1)) / std::cos(half_angle));
      largest_error = std::max(largest_error, std::abs(displacement(simulation) - exact));
    }
    CHECK(largest_error < 1e-10);
  }
}

TEST_CASE("the error falls with the square of the time step") {
  const double end = 5.0;
  const auto error = [&](int n_steps) {
    const double time_step = end / (n_steps + 0.5);
    Simulation simulation = pulled_oscillator(time_step);
    for (int n = 0; n < n_steps; ++n) simulation.step();
    // `end` is the time since the turning point, half a step before the start.
    return std::abs(displacement(simulation) - force / stiffness * (1.0 - std::cos(frequency * end)));
  };
  for (const int n_steps : {50, 100, 200}) {
    const double order = std::log2(error(n_steps) / error(2 * n_steps));
    CHECK(order > 1.95);
    CHECK(order < 2.05);
  }
}

TEST_CASE("steps are stable up to 2/ω and no further") {
  const double critical = 2.0 / frequency;
  const double amplitude = 2.0 * force / stiffness;
  CHECK(largest_displacement(0.99 * critical, 20'000) < 10.0 * amplitude);
  CHECK(largest_displacement(1.01 * critical, 1'000) > 1e6 * amplitude);
}
