// The column cases stepped to rest against one sparse solve of the same stiffness.
#include <doctest/doctest.h>

#include <cmath>

#include "build/build_simulation.hpp"
#include "reference/direct_solution.hpp"

using namespace ligament;

namespace {

double largest(const Field<Vector>& values) {
  double result = 0.0;
  for (const Vector& value : values) result = std::max(result, norm(value));
  return result;
}

double largest_difference(const Field<Vector>& a, const Field<Vector>& b) {
  double result = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, norm(a[i] - b[i]));
  return result;
}

}  // namespace

TEST_CASE("relaxed columns agree with the direct solution to 1e-6") {
  for (const char* name :
       {"column_fem", "column_hexagonal_h1", "column_hexagonal_h2", "column_random_r1", "column_random_r2"}) {
    CAPTURE(name);
    Case input = read_case(std::string(LIGAMENT_SOURCE_DIR "/config/") + name + ".toml", {});
    Simulation simulation = build_simulation(input).simulation;
    // At rest the resultants are the loads.
    const auto direct =
        reference::solve_directly(simulation.model(), simulation.state(), simulation.state().nodes.translation.force);
    while (simulation.unbalance().ratio() > 1e-9) {
      simulation.step();
      REQUIRE(simulation.state().clock.step < 20000);
    }
    const State& state = simulation.state();
    const double scale = largest(direct.node_displacement);
    CHECK(largest_difference(state.nodes.translation.displacement, direct.node_displacement) < 1e-6 * scale);
    CHECK(largest_difference(state.particles.translation.displacement, direct.particle_displacement) < 1e-6 * scale);
  }
}
