#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "build/build_simulation.hpp"
#include "build/select_bodies.hpp"
#include "core/state_hash.hpp"
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

TEST_CASE("a row that must snap sets the energy free that its bonds store beyond what the break takes" *
          doctest::test_suite("slow")) {
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

TEST_CASE("after a jump the motion before it is remembered, until an increment does without many evaluations") {
  // Few bonds that snap all the same: the row gives way further than a bond takes to soften.
  constexpr int n_bonds = 60;
  Row row(n_bonds + 1, 1.2 * n_bonds * 2e-6);
  const LoadingState& loading = row.state().loading;
  int n_jumps = 0;
  while (row.state().clock.time < 1.0 - 1e-9) {
    const std::int64_t evaluations_before = loading.n_evaluations;
    const bool had_two = !loading.older_direction.empty();
    REQUIRE(row.simulation.advance());
    const std::int64_t evaluations = loading.n_evaluations - evaluations_before;
    if (!loading.older_direction.empty()) {
      ++n_jumps;
      CHECK(evaluations > 30);
      CHECK(loading.older_direction.size() == loading.direction.size());
    } else if (had_two) {
      CHECK(evaluations < 40);
    }
  }
  CHECK(n_jumps >= 1);
  CHECK(loading.older_direction.empty());
}

TEST_CASE("an increment without equilibrium within its limits leaves the last one as it was") {
  // It would have to stay in equilibrium longer than it may take.
  Row row(21, 20e-6, {}, "settled_evaluations", std::int64_t{1} << 40);
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

TEST_CASE("no increment steps over a corner of a schedule, and a hold stays where it is") {
  // Strides of 1 μm do not fit into any of the lines.
  const PiecewiseLinear schedule{{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 3.5e-6, 3.5e-6, -1.25e-6, 0.0}};
  Row row(11, 0.0, {{.schedule = schedule}}, "load_steps", std::int64_t{2});
  std::vector<double> times;
  while (row.state().clock.time < 4.0 - 1e-9) {
    REQUIRE(row.simulation.advance());
    times.push_back(row.state().clock.time);
    CHECK(row.extension() == doctest::Approx(schedule.value(times.back())).epsilon(1e-12).scale(1e-6));
    CHECK(row.pull() == doctest::Approx(0.1 * row.stiffness() * row.extension()).epsilon(1e-6).scale(100.0));
  }
  CHECK(times.size() == 4 + 2 + 5 + 2);
  for (const double corner : {1.0, 2.0, 3.0, 4.0}) {
    CHECK(std::any_of(times.begin(), times.end(), [&](double time) { return std::abs(time - corner) < 1e-12; }));
  }
  CHECK(std::abs(energy(row.simulation, "prescribed_motions")) < 1e-6 * 0.5 * row.stiffness() * 3.5e-6 * 3.5e-6);
}

TEST_CASE("a bond that softens, unloads and is pulled again within one schedule spends G A once") {
  const PiecewiseLinear schedule{{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 20e-6, -1e-6, 120e-6, 118e-6}};
  Row row(2, 0.0, {{.schedule = schedule}});
  double spent = 0.0;
  while (row.state().clock.time < 4.0 - 1e-9) {
    REQUIRE(row.simulation.advance());
    row.simulation.audit();
    const double now = energy(row.simulation, "fracture_tension");
    // Between the corners at 1 s and 3 s it spends only beyond where it has been.
    if (row.state().clock.time > 1.0 + 1e-9 && row.extension() <= 20e-6) {
      CHECK(now == doctest::Approx(spent).epsilon(1e-12));
    }
    spent = now;
  }
  CHECK(spent == doctest::Approx(fracture_energy * row.area()).epsilon(1e-10));
  CHECK(row.state().ledger.largest_error < 1e-5);
}

TEST_CASE("the way to an equilibrium can be watched, and watching changes nothing") {
  Row watched(11, 5e-6);
  Row alone(11, 5e-6);
  std::vector<std::int64_t> evaluations;
  watched.simulation.observe_increments_by({2, [&](std::int64_t evaluation, double kinetic) {
                                              evaluations.push_back(evaluation);
                                              CHECK(kinetic >= 0.0);
                                            }});
  REQUIRE(watched.simulation.advance());
  REQUIRE(alone.simulation.advance());
  CHECK(evaluations.size() == static_cast<std::size_t>(watched.state().loading.n_evaluations / 2));
  for (std::size_t i = 0; i < evaluations.size(); ++i) CHECK(evaluations[i] == 2 * static_cast<std::int64_t>(i + 1));
  CHECK(state_hash(watched.state()) == state_hash(alone.state()));
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
