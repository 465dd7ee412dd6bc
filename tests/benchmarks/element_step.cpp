#include "counters.hpp"
#include "mesh/element_forces.hpp"
#include "support/element_model.hpp"
#include "support/resting_state.hpp"

/// Internal forces of a square of elements.
namespace {

using namespace ligament;
using namespace ligament::benchmarks;

void element_step(benchmark::State& run) {
  const auto n_per_side = static_cast<int>(run.range(0));
  const std::vector<double> lines = support::even_lines(0.0, 1.0, n_per_side);
  const Model model = support::element_model(build_structured_mesh({lines, lines}, {}),
                                             {.young_modulus = 20e9, .poisson_ratio = 0.2, .density = 2400.0});
  State state = support::resting_state(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.nodes.translation.displacement[i] = 1e-4 * cross(1.0, model.nodes.position[i]);
  }
  ElementForces forces;
  for ([[maybe_unused]] auto _ : run) {
    forces.add_forces(model, state);
    benchmark::ClobberMemory();
  }
  count_items(run, "elements", model.elements.size());
}
BENCHMARK(element_step)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
