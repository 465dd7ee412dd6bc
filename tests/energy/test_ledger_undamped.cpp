#include <doctest/doctest.h>

#include <cmath>

#include "support/bar_model.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

double term(const Simulation& simulation, const std::string& name) {
  for (const EnergyTerm& line : simulation.energies()) {
    if (line.name == name) return line.value;
  }
  FAIL("no line " << name);
  return 0.0;
}

/// Steps, audits every 100 steps, returns the largest error.
double run_audited(Simulation& simulation, int n_steps) {
  for (int i = 1; i <= n_steps; ++i) {
    simulation.step();
    if (i % 100 == 0) simulation.audit();
  }
  return simulation.state().ledger.largest_error;
}

}  // namespace

TEST_CASE("two masses and a spring: no drift in 200 000 steps") {
  Model model = bar_model(1, 1.0);
  SimulationChoice choice;
  choice.loads = pull(section(model, 1), 1.0);
  // Equal and opposite: the pair stays where it is.
  for (const PointLoad& load : pull(section(model, 0), -1.0)) choice.loads.push_back(load);
  choice.time_step.factor = 0.9;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  CHECK(run_audited(simulation, 200'000) < 1e-12);
  CHECK(term(simulation, "elastic_elements") > 0.0);
  CHECK(term(simulation, "kinetic_nodes") > 0.0);
  CHECK(term(simulation, "damping") == 0.0);
}

TEST_CASE("two bonded discs: no drift in 200 000 steps") {
  Model model = empty_model({.poisson_ratio = 0.2});
  add_particle(model, {0.0, 0.0}, 0.5);
  add_particle(model, {1.0, 0.0}, 0.5);
  const double normal_stiffness = 1e9 / (1.0 - 0.04);
  SimulationChoice choice;
  const Vector force{1e-6 * normal_stiffness, 0.0};
  choice.loads = {{.body = PointLoad::Body::particle, .row = 0, .force = -force},
                  {.body = PointLoad::Body::particle, .row = 1, .force = force}};
  choice.time_step.factor = 0.9;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  CHECK(run_audited(simulation, 200'000) < 1e-12);
  CHECK(term(simulation, "elastic_contacts") >= 0.0);
}

TEST_CASE("kinetic energy is ½ m v(n-½)·v(n+½): none at the start, and less than nothing at a turning point") {
  Model model = bar_model(1, 1.0);
  hold(model, section(model, 0));
  SimulationChoice choice;
  choice.loads = pull(section(model, 1), 1.0);
  choice.time_step.factor = 0.7;
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  CHECK(term(simulation, "kinetic_nodes") == 0.0);
  CHECK(simulation.audit() == 0.0);

  double smallest = 0.0;
  double largest_miss = 0.0;
  for (int i = 0; i < 1000; ++i) {
    simulation.step();
    const TranslationState& nodes = simulation.state().nodes.translation;
    double kinetic = 0.0;
    for (const Index node : section(simulation.model(), 1)) {
      kinetic += 0.5 * nodes.mass[node] * dot(nodes.velocity_before[node], nodes.velocity[node]);
    }
    largest_miss = std::max(largest_miss, std::abs(kinetic - term(simulation, "kinetic_nodes")));
    smallest = std::min(smallest, kinetic);
    simulation.audit();
  }
  CHECK(largest_miss < 1e-15);
  CHECK(smallest < -1e-3);
  CHECK(simulation.state().ledger.largest_error < 1e-13);
}

TEST_CASE("each kind of body has its line of kinetic energy") {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  SimulationChoice choice;
  choice.time_step = {.masses = Masses::real, .time_step = 0.1};
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  set_velocity(simulation, 0, {3.0, 4.0}, 2.0);
  const double mass = simulation.model().particles.real_mass[0];
  CHECK(term(simulation, "kinetic_particles") == doctest::Approx(0.5 * mass * 25.0));
  CHECK(term(simulation, "kinetic_rotation") == doctest::Approx(0.5 * (0.5 * mass * 0.25) * 4.0));
  CHECK(term(simulation, "kinetic_nodes") == 0.0);
}
