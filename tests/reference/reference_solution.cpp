// Prints the elastic answer of a case from one sparse solve, by the names of its gauges (JSON):
//   reference_solution CASE.toml
#include <cstdio>
#include <nlohmann/json.hpp>

#include "build/build_simulation.hpp"
#include "core/error.hpp"
#include "reference/direct_solution.hpp"

namespace {

using namespace ligament;

/// A state at rest in the solution: displaced bodies, resultants that only reactions balance.
State state_of(const reference::DirectSolution& solution, State state) {
  state.nodes.translation.displacement = solution.node_displacement;
  state.particles.translation.displacement = solution.particle_displacement;
  state.particles.rotation.rotation = solution.particle_rotation;
  for (TranslationState* bodies : {&state.nodes.translation, &state.particles.translation}) {
    bodies->velocity_before.assign(bodies->velocity_before.size(), Vector{});
    bodies->velocity.assign(bodies->velocity.size(), Vector{});
  }
  for (std::size_t i = 0; i < solution.node_reaction.size(); ++i) {
    state.nodes.translation.force[i] = -solution.node_reaction[i];
  }
  for (std::size_t i = 0; i < solution.particle_reaction.size(); ++i) {
    state.particles.translation.force[i] = -solution.particle_reaction[i];
  }
  return state;
}

nlohmann::ordered_json solve(const char* path) {
  Case input = read_case(path, {});
  const BuiltSimulation built = build_simulation(input);
  const Model& model = built.simulation.model();
  // At rest the resultants are the loads.
  const Field<Vector>& loads = built.simulation.state().nodes.translation.force;
  const State state =
      state_of(reference::solve_directly(model, built.simulation.state(), loads), built.simulation.state());
  nlohmann::ordered_json values;
  for (const Gauge& gauge : built.gauges) values[gauge.column] = gauge.value(model, state);
  return values;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: reference_solution CASE.toml\n");
    return 2;
  }
  try {
    std::printf("%s\n", solve(argv[1]).dump(2).c_str());
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.code());
  }
}
