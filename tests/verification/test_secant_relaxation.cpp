#include <doctest/doctest.h>

#include <cmath>

#include "build/build_simulation.hpp"
#include "build/select_bodies.hpp"
#include "core/state_hash.hpp"
#include "reference/direct_solution.hpp"
#include "support/disc_row.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// The last disc moves as far as it takes, up to 150 um; increments of 0.5 um open the first bond, which is the
/// weakest.
constexpr int n_bonds = 40;

Row followed_row() {
  const Index first = 0;
  const Index second = FreedomNumbers::per_particle;
  return {n_bonds + 1, 150e-6, {}, "increment", 0.5e-6, "secant", {{first, -1.0}, {second, 1.0}}};
}

double first_opening(const Row& row) { return row.state().particles.translation.displacement[1].x; }

/// Opening of the first bond less that of its spring (m).
double crack_opening(const Row& row) { return first_opening(row) - row.pull() / row.stiffness(); }

double compliance(const Row& row) {
  double sum = 0.0;
  for (const double stiffness : row.state().particle_contacts.normal_stiffness) sum += 1.0 / stiffness;
  return sum;
}

}  // namespace

TEST_CASE(
    "a softening bond in series with springs is followed through its snap-back, where its opening is the control") {
  Row row = followed_row();
  const double springs = compliance(row);
  double furthest = 0.0;
  double largest_way_back = 0.0;
  for (int i = 1; i <= 220; ++i) {
    REQUIRE(row.simulation.advance());
    row.simulation.audit();
    CHECK(first_opening(row) == doctest::Approx(0.5e-6 * i).epsilon(1e-9));
    const double w = crack_opening(row);
    if (w > 1e-10) CHECK(row.pull() == doctest::Approx(softened_strength(w) * row.area()).epsilon(1e-6));
    CHECK(row.extension() == doctest::Approx(springs * row.pull() + std::max(0.0, w)).epsilon(1e-4));
    furthest = std::max(furthest, row.extension());
    largest_way_back = std::max(largest_way_back, furthest - row.extension());
  }
  CHECK(row.state().particle_contacts.bond[0] == BondState::broken);
  // From the peak to the kink of the curve.
  const double kink = 0.75 * fracture_energy / strength;
  CHECK(largest_way_back == doctest::Approx(0.75 * springs * strength * row.area() - kink).epsilon(0.05));
  const double spent = fracture_energy * row.area();
  CHECK(energy(row.simulation, "fracture_tension") == doctest::Approx(spent).epsilon(1e-9));
  CHECK(energy(row.simulation, "prescribed_motions") == doctest::Approx(spent).epsilon(5e-3));
  CHECK(std::abs(energy(row.simulation, "released")) < 5e-3 * spent);
  CHECK(row.state().ledger.largest_error < 1e-3);
}

TEST_CASE("a run that is taken up in the middle of a snap-back goes on to the same bits") {
  Row whole = followed_row();
  for (int i = 0; i < 10; ++i) REQUIRE(whole.simulation.advance());
  const double time_before = whole.state().clock.time;
  Row other = followed_row();
  other.simulation.restore(whole.state());
  for (int i = 0; i < 10; ++i) {
    REQUIRE(whole.simulation.advance());
    REQUIRE(other.simulation.advance());
  }
  CHECK(whole.state().clock.time < time_before);
  CHECK(state_hash(whole.state()) == state_hash(other.state()));
}

TEST_CASE("without a gauge the motion is the control, as with momenta") {
  Row by_secants(2, 120e-6, {}, "increment", 1e-6, "secant");
  Row by_momenta(2, 120e-6);
  for (int i = 0; i < 120; ++i) {
    REQUIRE(by_secants.simulation.advance());
    REQUIRE(by_momenta.simulation.advance());
    CHECK(by_secants.pull() == doctest::Approx(by_momenta.pull()).epsilon(1e-9));
  }
  CHECK(by_secants.state().clock.time == doctest::Approx(1.0));
}

TEST_CASE("where the gauge can go no further the motion goes on by time, over the jump to what is left") {
  // The second bond is the control: with the first one at its strength it can be stretched no more.
  const Index second = FreedomNumbers::per_particle;
  Row row(n_bonds + 1, 150e-6, {}, "increment", 0.1e-6, "secant", {{second, -1.0}, {2 * second, 1.0}});
  const double springs = compliance(row);
  double peak = 0.0;
  while (row.state().loading.n_without_control == 0) {
    peak = row.pull();
    REQUIRE(row.simulation.advance());
    row.simulation.audit();
  }
  CHECK(peak == doctest::Approx(strength * row.area()).epsilon(0.05));
  const double w = crack_opening(row);
  CHECK(w > 0.75 * fracture_energy / strength);
  CHECK(row.pull() == doctest::Approx(softened_strength(w) * row.area()).epsilon(1e-4));
  CHECK(row.extension() == doctest::Approx(springs * row.pull() + w).epsilon(1e-4));
  CHECK(row.state().ledger.largest_error < 1e-3);
}

TEST_CASE("loading that is followed by a gauge ends with its stage") {
  Row row(2, 10e-6, {}, "increment", 3e-6, "secant", {{FreedomNumbers::per_particle, 1.0}});
  for (int i = 0; i < 4; ++i) REQUIRE(row.simulation.advance());
  CHECK(row.state().clock.time == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(row.extension() == doctest::Approx(10e-6).epsilon(1e-12));
}

TEST_CASE("an elastic structure is solved at once, with one factorisation for all increments") {
  Case input = read_case(LIGAMENT_SOURCE_DIR "/config/column_hexagonal_h2.toml",
                         {"solver.method=secant", "solver.increment=\"1 um\"", "solver.load_steps=2",
                          "load.right_end_corners.rise_time=\"1 s\"", "load.right_end_inside.rise_time=\"1 s\""});
  Simulation simulation = build_simulation(input).simulation;
  for (int i = 0; i < 2; ++i) REQUIRE(simulation.advance());
  CHECK(simulation.state().loading.n_factorisations == 1);
  CHECK(simulation.state().loading.n_relaxed == 0);
  // One or two find the equilibrium, one more books the work on the way to it.
  CHECK(simulation.state().loading.n_evaluations <= 6);
  CHECK(simulation.audit() < 1e-6);
  Field<Vector> loads(simulation.model().nodes.size());
  for (const auto& [table, view] : input.loads) {
    for (const std::int64_t number : table.bodies.nodes) {
      loads[row_of_id(simulation.model().nodes.id, number)] = to_vector(table.force);
    }
  }
  const auto direct = reference::solve_directly(simulation.model(), simulation.state(), loads);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    CHECK(norm(simulation.state().nodes.translation.displacement[i] - direct.node_displacement[i]) < 1e-4 * 2.4e-6);
  }
}
