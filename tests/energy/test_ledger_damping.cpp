#include <doctest/doctest.h>

#include <cmath>

#include "integrator/dynamic_relaxation.hpp"
#include "integrator/local_damping.hpp"
#include "support/bar_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

Simulation damped_bar(std::unique_ptr<Damping> damping, double rise_time) {
  Model model = bar_model(20, 1.0);
  hold(model, section(model, 0));
  SimulationChoice choice;
  choice.loads = pull(last_section(model), 3.0, rise_time);
  choice.time_step.factor = 0.9;
  choice.damping = std::move(damping);
  return make_simulation(std::move(model), std::move(choice));
}

std::unique_ptr<Damping> make(bool viscous) {
  if (viscous) return std::make_unique<DynamicRelaxation>();
  return std::make_unique<LocalDamping>();
}

EnergyBalance balance_of(const Simulation& simulation) {
  EnergyBalance balance;
  for (const EnergyTerm& term : simulation.energies()) balance.add(term);
  return balance;
}

}  // namespace

TEST_CASE("the work of damping is the energy that is lost, at every step") {
  for (const bool viscous : {true, false}) {
    for (const double rise_time : {0.0, 2.0}) {
      Simulation simulation = damped_bar(make(viscous), rise_time);
      for (int i = 0; i < 20'000; ++i) {
        simulation.step();
        simulation.audit();
      }
      CHECK(simulation.state().ledger.largest_error < 1e-12);
      const EnergyBalance balance = balance_of(simulation);
      CHECK(balance.dissipated > 0.0);
      CHECK(balance.elastic == doctest::Approx(4.5).epsilon(1e-6));
    }
  }
}

TEST_CASE("under a load that acts at once damping takes half of its work") {
  for (const bool viscous : {true, false}) {
    Simulation simulation = damped_bar(make(viscous), 0.0);
    for (int i = 0; i < 20'000; ++i) simulation.step();
    const EnergyBalance balance = balance_of(simulation);
    CHECK(balance.work == doctest::Approx(9.0).epsilon(1e-6));
    CHECK(balance.dissipated == doctest::Approx(4.5).epsilon(1e-6));
  }
}
