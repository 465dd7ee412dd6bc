#include <doctest/doctest.h>

#include <cmath>

#include "integrator/dynamic_relaxation.hpp"
#include "integrator/local_damping.hpp"
#include "reference/direct_solution.hpp"
#include "support/bar_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// The tensioned column of finite elements alone: 6 × 3 elements, held at the left, pulled at the right.
Model tensioned_column() {
  Model model = element_model(build_structured_mesh({even_lines(0.0, 4.8, 6), {0.0, 0.33, 0.67, 1.0}}, {}),
                              {.young_modulus = 20e9, .poisson_ratio = 0.2, .density = 2400.0});
  for (const Index node : {0, 7, 14, 21}) model.nodes.free[node] = {0.0, 1.0};
  model.nodes.free[0] = {};
  return model;
}

std::vector<PointLoad> loads_of_column() {
  return {{.row = 6, .force = {1670.0, 0.0}},
          {.row = 13, .force = {3330.0, 0.0}},
          {.row = 20, .force = {3330.0, 0.0}},
          {.row = 27, .force = {1670.0, 0.0}}};
}

reference::DirectSolution solution_of_column(const Model& model) {
  Field<Vector> loads(model.nodes.size());
  for (const PointLoad& load : loads_of_column()) loads[load.row] = load.force;
  return reference::solve_directly(model, resting_state(model), loads);
}

/// Steps until the unbalanced forces are small; returns the number of steps, at most `limit`.
int relax(Simulation& simulation, double unbalanced_force_ratio, int limit) {
  for (int n = 1; n <= limit; ++n) {
    simulation.step();
    if (simulation.unbalance().ratio() <= unbalanced_force_ratio) return n;
  }
  return limit;
}

SimulationChoice relaxation(std::unique_ptr<Damping> damping) {
  SimulationChoice choice;
  choice.time_step = {.masses = Masses::scaled};
  choice.damping = std::move(damping);
  return choice;
}

double largest_difference(const Simulation& simulation, const reference::DirectSolution& exact) {
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.node_displacement.size(); ++i) {
    largest =
        std::max(largest, norm(simulation.state().nodes.translation.displacement[i] - exact.node_displacement[i]));
  }
  return largest;
}

}  // namespace

TEST_CASE("both dampings bring a bar to rest at F L / E A") {
  for (const bool viscous : {true, false}) {
    Model model = bar_model(10, 1.0);
    hold(model, section(model, 0));
    const Index end = last_section(model)[0];
    SimulationChoice choice =
        viscous ? relaxation(std::make_unique<DynamicRelaxation>()) : relaxation(std::make_unique<LocalDamping>());
    choice.loads = pull(last_section(model), 3.0);
    Simulation simulation = make_simulation(std::move(model), std::move(choice));
    CHECK(relax(simulation, 1e-9, 20'000) < 20'000);
    CHECK(simulation.state().nodes.translation.displacement[end].x == doctest::Approx(3.0).epsilon(1e-7));
  }
}

TEST_CASE("dynamic relaxation of the tensioned column ends at the direct solution") {
  SimulationChoice choice = relaxation(std::make_unique<DynamicRelaxation>());
  choice.loads = loads_of_column();
  Simulation simulation = make_simulation(tensioned_column(), std::move(choice));
  CHECK(relax(simulation, 1e-9, 2000) < 2000);

  const auto exact = solution_of_column(simulation.model());
  CHECK(largest_difference(simulation, exact) < 1e-6 * 2.4e-6);
  for (const Index node : {0, 7, 14, 21}) {
    const State& state = simulation.state();
    const Vector held = reaction(state.nodes.translation, simulation.model().nodes.free, state.clock, node);
    CHECK(held.x == doctest::Approx(exact.node_reaction[node].x).epsilon(1e-6));
  }
}

TEST_CASE("the column is at rest within the paper's 160 steps if nothing holds it across") {
  // Loads and supports balance across the column, so that none is needed.
  Model model = tensioned_column();
  model.nodes.free[0] = {0.0, 1.0};
  SimulationChoice choice = relaxation(std::make_unique<DynamicRelaxation>());
  choice.loads = loads_of_column();
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  CHECK(relax(simulation, 1e-6, 1000) <= 160);

  const auto exact = solution_of_column(tensioned_column());
  for (const PointLoad& load : loads_of_column()) {
    const double displacement = simulation.state().nodes.translation.displacement[load.row].x;
    CHECK(displacement == doctest::Approx(exact.node_displacement[load.row].x).epsilon(1e-6));
  }
}

TEST_CASE("held across at one node, the column has to bend its way there, which is five times slower") {
  SimulationChoice choice = relaxation(std::make_unique<DynamicRelaxation>());
  choice.loads = loads_of_column();
  Simulation simulation = make_simulation(tensioned_column(), std::move(choice));
  CHECK(relax(simulation, 1e-3, 1000) <= 160);
  CHECK(relax(simulation, 1e-6, 1000) <= 500);
}
