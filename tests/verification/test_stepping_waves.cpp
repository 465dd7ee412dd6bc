#include <doctest/doctest.h>

#include <cmath>

#include "support/bar_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double length = 2.0;
constexpr int n_elements = 400;
constexpr double middle = 0.5 * length;
// 16 elements: the lengths of waves it is made of are 50 elements and more, their speed is within 2e-3 of c = 1.
constexpr double width = 16.0 * length / n_elements;

double pulse(double x) { return std::exp(-(x - middle) * (x - middle) / (2.0 * width * width)); }
double slope_of_pulse(double x) { return -(x - middle) / (width * width) * pulse(x); }

/// A pulse u = f(x - t) that runs to the right from the middle of the bar at time 0.
Simulation travelling_pulse(bool end_is_held) {
  Model model = bar_model(n_elements, length);
  if (end_is_held) hold(model, last_section(model));
  SimulationChoice choice;
  choice.time_step.factor = 0.5;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  State state = simulation.state();
  TranslationState& nodes = state.nodes.translation;
  const double half_step = 0.5 * state.clock.time_step;
  for (std::size_t i = 0; i < nodes.displacement.size(); ++i) {
    const double x = simulation.model().nodes.position[i].x;
    nodes.displacement[i] = {pulse(x), 0.0};
    nodes.velocity[i] = {-slope_of_pulse(x - half_step), 0.0};
  }
  simulation.restore(std::move(state));
  return simulation;
}

void run_until(Simulation& simulation, double time) {
  while (simulation.state().clock.time < time) simulation.step();
}

/// The largest difference from `factor` times the pulse at its place of time 0.
double difference_from_pulse(const Simulation& simulation, double factor) {
  double largest = 0.0;
  const State& state = simulation.state();
  for (std::size_t i = 0; i < simulation.model().nodes.size(); ++i) {
    // The pulse runs to the left now.
    const double x = simulation.model().nodes.position[i].x + (state.clock.time - length);
    largest = std::max(largest, std::abs(state.nodes.translation.displacement[i].x - factor * pulse(x)));
  }
  return largest;
}

}  // namespace

TEST_CASE("a wave reaches the free end after L/c and doubles there") {
  Simulation simulation = travelling_pulse(false);
  const Index end = last_section(simulation.model())[0];
  double largest = 0.0;
  double arrival = 0.0;
  while (simulation.state().clock.time < length) {
    simulation.step();
    const double displacement = simulation.state().nodes.translation.displacement[end].x;
    if (displacement > largest) arrival = simulation.state().clock.time;
    largest = std::max(largest, displacement);
  }
  CHECK(arrival == doctest::Approx(length - middle).epsilon(2e-3));
  CHECK(largest == doctest::Approx(2.0).epsilon(5e-3));
}

TEST_CASE("a free end returns the wave, a held one turns it over") {
  for (const bool end_is_held : {false, true}) {
    Simulation simulation = travelling_pulse(end_is_held);
    CHECK(difference_from_pulse(simulation, 1.0) > 0.9);
    run_until(simulation, length);
    CHECK(difference_from_pulse(simulation, end_is_held ? -1.0 : 1.0) < 0.01);
  }
}

TEST_CASE("a suddenly pulled bar oscillates between nothing and twice the static displacement") {
  Model model = bar_model(100, 1.0);
  hold(model, section(model, 0));
  SimulationChoice choice;
  choice.loads = pull(last_section(model), 1.0);
  choice.time_step.factor = 0.9;
  const Index end = last_section(model)[0];
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  // The end moves with σ/(ρ c) = 1 until the wave is back at 2 L/c, then back.
  for (const double time : {0.5, 1.0, 1.5, 1.9}) {
    run_until(simulation, time);
    CHECK(simulation.state().nodes.translation.displacement[end].x == doctest::Approx(time).epsilon(0.01));
  }
  run_until(simulation, 3.0);
  CHECK(simulation.state().nodes.translation.displacement[end].x == doctest::Approx(1.0).epsilon(0.02));
  run_until(simulation, 4.0);
  CHECK(std::abs(simulation.state().nodes.translation.displacement[end].x) < 0.03);
}
