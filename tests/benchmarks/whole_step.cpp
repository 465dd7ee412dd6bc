#include "whole_step.hpp"

#include <filesystem>

#include "build/build_simulation.hpp"
#include "core/parallel.hpp"
#include "counters.hpp"
#include "lattice.hpp"

namespace ligament::benchmarks {
namespace {

void time_steps(benchmark::State& run, Simulation& simulation, int n_threads) {
  threads().count = n_threads;
  for (int i = 0; i < 20; ++i) simulation.step();
  for ([[maybe_unused]] auto _ : run) simulation.step();
  threads() = {};
  const State& state = simulation.state();
  count_items(run, "contacts",
              state.particle_contacts.size() + state.facet_contacts.size() + state.corner_contacts.size());
}

/// Particles alone, with dynamic relaxation.
void whole_step(benchmark::State& run) {
  Simulation simulation = settling_lattice(static_cast<std::size_t>(run.range(0)));
  time_steps(run, simulation, static_cast<int>(run.range(1)));
}
BENCHMARK(whole_step)
    ->ArgNames({"particles", "threads"})
    ->ArgsProduct({{3'000, 10'000, 100'000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

void register_case_step(const std::string& path) {
  const std::string name = "case_step/" + std::filesystem::path(path).stem().string();
  benchmark::RegisterBenchmark(name.c_str(),
                               [path](benchmark::State& run) {
                                 Case input = read_case(path, {});
                                 BuiltSimulation built = build_simulation(input);
                                 time_steps(run, built.simulation, static_cast<int>(run.range(0)));
                               })
      ->ArgName("threads")
      ->Arg(1)
      ->Arg(2)
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace ligament::benchmarks
