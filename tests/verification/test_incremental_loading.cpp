#include <doctest/doctest.h>

#include <cmath>

#include "build/build_simulation.hpp"
#include "build/select_bodies.hpp"
#include "reference/direct_solution.hpp"
#include "support/disc_row.hpp"

using namespace ligament;
using namespace ligament::support;

TEST_CASE("a bond that is pulled apart in increments follows its curve and spends G A, nothing else") {
  Row row(2, 120e-6);
  while (row.state().clock.time < 1.0 - 1e-9) {
    REQUIRE(row.simulation.advance());
    const double w = row.extension() - row.pull() / row.stiffness();
    if (row.extension() * row.stiffness() > 1.001 * strength * row.area()) {
      CHECK(row.pull() == doctest::Approx(softened_strength(w) * row.area()).epsilon(1e-9));
    } else {
      CHECK(row.pull() == doctest::Approx(row.stiffness() * row.extension()).epsilon(1e-9));
    }
    row.simulation.audit();
  }
  CHECK(row.state().clock.step == 120);
  CHECK(row.state().particle_contacts.bond[0] == BondState::broken);
  CHECK(energy(row.simulation, "fracture_tension") == doctest::Approx(fracture_energy * row.area()).epsilon(1e-10));
  // A softening curve of straight lines is not integrated exactly where an increment holds its peak, kink or end.
  CHECK(energy(row.simulation, "prescribed_motions") == doctest::Approx(fracture_energy * row.area()).epsilon(2e-3));
  CHECK(row.state().ledger.largest_error < 1e-5);
}

TEST_CASE("a row that must snap sets the energy free that its bonds store beyond what the break takes") {
  // At the strength of the weakest bond, so many springs in series store more than its break takes.
  constexpr int n_bonds = 200;
  Row row(n_bonds + 1, 1.2 * n_bonds * 2e-6);
  double stored = 0.0;
  double work = 0.0;
  while (row.state().clock.time < 1.0 - 1e-9) {
    const double before = energy(row.simulation, "elastic_contacts");
    const double pull_before = row.pull();
    REQUIRE(row.simulation.advance());
    row.simulation.audit();
    if (row.pull() < 0.5 * pull_before && stored == 0.0) {
      stored = before;
      work = 0.5 * (pull_before + row.pull()) * 1e-6;
    }
  }
  REQUIRE(stored > 0.0);
  const double spent = fracture_energy * row.area();
  CHECK(energy(row.simulation, "fracture_tension") == doctest::Approx(spent).epsilon(1e-6));
  CHECK(energy(row.simulation, "released") == doctest::Approx(stored + work - spent).epsilon(1e-3));
  CHECK(energy(row.simulation, "released") > 0.0);
  CHECK(row.state().ledger.largest_error < 1e-4);
}

TEST_CASE("an increment without equilibrium within its limits leaves the last one as it was") {
  Row row(21, 20e-6, {}, "most_evaluations", std::int64_t{10});
  State before = row.state();
  const bool found = row.simulation.advance();
  CHECK_FALSE(found);
  CHECK(row.state().clock.step == before.clock.step);
  CHECK(row.state().clock.time == before.clock.time);
  CHECK(row.state().particle_contacts.opening == before.particle_contacts.opening);
  CHECK(row.state().particles.translation.displacement == before.particles.translation.displacement);
}

TEST_CASE("unloading and loading again within the elastic range comes back without a loss") {
  Row row(11, 0.0, {{.velocity = 5e-6, .stop_time = 1.0}, {.stage = 2, .velocity = -5e-6, .stop_time = 1.0}});
  while (row.state().clock.time < 1.0 - 1e-9) REQUIRE(row.simulation.advance());
  const double pull = row.pull();
  CHECK(pull == doctest::Approx(0.1 * row.stiffness() * 5e-6).epsilon(1e-6));
  row.simulation.finish_stage({});
  while (row.state().clock.time < 2.0 - 1e-9) REQUIRE(row.simulation.advance());
  CHECK(row.state().clock.step == 10);
  CHECK(std::abs(row.pull()) < 1e-6 * pull);
  CHECK(std::abs(energy(row.simulation, "prescribed_motions")) < 1e-6 * pull * 5e-6);
}

TEST_CASE("an elastic structure under loads in increments comes to the direct solution") {
  Case input = read_case(LIGAMENT_SOURCE_DIR "/config/column_hexagonal_h2.toml",
                         {"solver.method=quasi_static", "solver.increment=\"1 um\"",
                          "solver.unbalanced_force_ratio=1e-9", "solver.force_mismatch=1e-9", "solver.load_steps=4",
                          "load.right_end_corners.rise_time=\"1 s\"", "load.right_end_inside.rise_time=\"1 s\""});
  Simulation simulation = build_simulation(input).simulation;
  for (int i = 0; i < 4; ++i) {
    REQUIRE(simulation.advance());
    simulation.audit();
  }
  CHECK(simulation.state().clock.time == doctest::Approx(1.0));
  CHECK(simulation.state().ledger.largest_error < 1e-7);
  Field<Vector> loads(simulation.model().nodes.size());
  for (const auto& [table, view] : input.loads) {
    for (const std::int64_t number : table.bodies.nodes) {
      loads[row_of_id(simulation.model().nodes.id, number)] = to_vector(table.force);
    }
  }
  const auto direct = reference::solve_directly(simulation.model(), simulation.state(), loads);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    CHECK(norm(simulation.state().nodes.translation.displacement[i] - direct.node_displacement[i]) < 1e-6 * 2.4e-6);
  }
}
