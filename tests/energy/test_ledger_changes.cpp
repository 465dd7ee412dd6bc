#include <doctest/doctest.h>

#include <cmath>

#include "support/bar_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Asks for a new look at the time step every 37 steps.
class EagerDetector : public ContactDetector {
 public:
  void bond(Model& /*model*/, State& /*state*/) override {}
  bool update(const Model& /*model*/, State& state) override { return state.clock.step % 37 == 0; }
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& /*model*/, const State& /*state*/) const override {
    return {};
  }
};

/// Pretends that the nodes feel more and more stiffness, without any force.
class RisingBound : public ForceProvider {
 public:
  void add_forces(const Model& /*model*/, State& /*state*/) override {}
  void add_stiffness(const Model& /*model*/, const State& state, StiffnessBounds& bounds) const override {
    for (std::size_t i = 0; i < bounds.node_translation.size(); ++i) {
      bounds.node_translation[i] += 1e-3 * static_cast<double>(state.clock.step) * static_cast<double>(1 + i % 3);
    }
  }
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& /*model*/, const State& /*state*/) const override {
    return {};
  }
};

/// A bar that oscillates under a load, with a bound that rises.
Simulation bar_under_rising_bound(const TimeStepChoice& time_step) {
  Model model = bar_model(10, 1.0);
  hold(model, section(model, 0));
  Modules modules;
  modules.integrator = std::make_unique<CentralDifference>(std::make_unique<NoDamping>());
  modules.contact_detector = std::make_unique<EagerDetector>();
  modules.force_providers.push_back(std::make_unique<ElementForces>());
  modules.force_providers.push_back(std::make_unique<AppliedLoads>(pull(last_section(model), 1.0)));
  modules.force_providers.push_back(std::make_unique<RisingBound>());
  return {std::move(model), std::move(modules), time_step};
}

double run_audited(Simulation& simulation, int n_steps) {
  for (int i = 0; i < n_steps; ++i) {
    simulation.step();
    simulation.audit();
  }
  return simulation.state().ledger.largest_error;
}

}  // namespace

TEST_CASE("the ledger closes while the time step falls") {
  Simulation simulation = bar_under_rising_bound({.masses = Masses::real, .factor = 0.9});
  const double first = simulation.state().clock.time_step;
  CHECK(run_audited(simulation, 8000) < 1e-12);
  CHECK(simulation.state().clock.time_step < 0.7 * first);
  CHECK(simulation.state().ledger.total("step_change") != 0.0);
}

TEST_CASE("the ledger closes while masses are raised") {
  Simulation simulation = bar_under_rising_bound({.masses = Masses::scaled, .safety = 1.1, .time_step = 0.01});
  const double first = simulation.state().nodes.translation.mass[5];
  CHECK(run_audited(simulation, 5000) < 1e-12);
  CHECK(simulation.state().clock.time_step == 0.01);
  CHECK(simulation.state().nodes.translation.mass[5] > 1.5 * first);
  CHECK(simulation.state().ledger.total("step_change") > 0.0);
}
