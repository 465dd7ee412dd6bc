#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "audit/step_audit.hpp"
#include "core/error.hpp"
#include "support/bar_model.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

/// A motion that means nothing any more is told at once, with the body, its place and what acts on it.
namespace ligament {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Five discs of radius 0.1 m in a row, bonded; the first is number 1.
Simulation row_of_discs(double skin = 1e-3) {
  Model model = support::empty_model();
  for (int i = 0; i < 5; ++i) support::add_particle(model, {0.2 * i, 0.0}, 0.1);
  return support::make_simulation(std::move(model), {.skin = skin});
}

/// What is said when it goes on for some steps; empty if nothing is. `n_steps` is where it ends.
std::string divergence_of(Simulation& simulation, int& n_steps, int most_steps = 2000) {
  try {
    for (n_steps = 1; n_steps <= most_steps; ++n_steps) simulation.step();
  } catch (const DivergenceError& error) {
    return error.what();
  }
  return {};
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("a number that is not finite ends the run at the next step") {
  Simulation simulation = row_of_discs();
  for (int step = 0; step < 10; ++step) simulation.step();
  State state = simulation.state();
  state.particles.translation.velocity[2] = {nan, 0.0};
  simulation.restore(std::move(state));
  int n_steps = 0;
  const std::string text = divergence_of(simulation, n_steps);
  CAPTURE(text);
  CHECK(n_steps == 1);
  CHECK(text.starts_with("step 11: particle 3 at (0.4, 0) m at rest has a number that is not finite"));
  CHECK(says(text, "; of its contacts that with particle "));
}

TEST_CASE("the audit of every step finds it at the step where it is born") {
  Simulation simulation = row_of_discs();
  simulation.step();
  StepAudit audit(simulation);
  for (const bool is_spin : {false, true}) {
    State state = simulation.state();
    (is_spin ? state.particles.rotation.moment[1] : state.particles.translation.force[1].x) = nan;
    simulation.restore(std::move(state));
    std::string text;
    try {
      audit.observe(simulation);
    } catch (const DivergenceError& error) {
      text = error.what();
    }
    CAPTURE(text);
    CHECK(text.starts_with("step 1: particle 2 at (0.2, 0) m has a number that is not finite"));
  }
}

TEST_CASE("a step that is too large ends the run before any number overflows") {
  // A search would mend the step: none comes with so thick a skin.
  Simulation simulation = row_of_discs(1.0);
  support::set_velocity(simulation, 0, {1e-3, 1e-3}, 0.01);
  State state = simulation.state();
  // Ten times the bound of stability, of which such a simulation takes a tenth.
  state.clock.time_step = state.clock.time_step_before = 100.0 * state.clock.time_step;
  simulation.restore(std::move(state));
  int n_steps = 0;
  const std::string text = divergence_of(simulation, n_steps);
  CAPTURE(text);
  CHECK(n_steps < 200);
  CHECK(says(text, " in one step; of its contacts that with particle "));
  for (const Vector& displacement : simulation.state().particles.translation.displacement) {
    CHECK(is_finite(displacement));
  }
}

TEST_CASE("a particle that runs away is named") {
  Simulation simulation = row_of_discs();
  support::set_velocity(simulation, 4, {0.0, 0.21 / simulation.state().clock.time_step});
  int n_steps = 0;
  const std::string text = divergence_of(simulation, n_steps);
  CAPTURE(text);
  CHECK(n_steps == 1);
  CHECK(says(text, "particle 5 at (0.8, 0.21) m has moved by 0.21 m in one step"));
  CHECK(says(text, "that with particle 4 has the largest force"));
}

TEST_CASE("a particle that spins away is named") {
  Simulation simulation = row_of_discs();
  support::set_velocity(simulation, 1, {}, 3.5 / simulation.state().clock.time_step);
  int n_steps = 0;
  CHECK(says(divergence_of(simulation, n_steps), "particle 2 at (0.2, 0) m has turned by 3.5 rad in one step"));
}

}  // namespace
}  // namespace ligament
