#include <malloc.h>
#include <sys/resource.h>

#include <ctime>
#include <fstream>

#include "counters.hpp"
#include "lattice.hpp"

/// How cost grows with the number of particles: what scripts/benchmark --growth draws.
namespace ligament::benchmarks {
namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Memory in use by the process (bytes).
double resident_memory() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double all_pages = 0.0;
  double resident_pages = 0.0;
  file >> all_pages >> resident_pages;
  return 4096.0 * resident_pages;
}

/// Largest memory that the process has used so far (bytes).
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Seconds that the search takes when it looks at everything again.
double rebuild_time(const Simulation& simulation) {
  State state = simulation.state();
  state.search.particle_displacement.front().x += 2.0 * lattice_skin;
  GridContactDetector detector(lattice_skin);
  const double begin = processor_seconds();
  detector.update(simulation.model(), state);
  return processor_seconds() - begin;
}

/// Seconds of one step, the mean of enough of them.
double step_time(Simulation& simulation, std::size_t n_contacts) {
  for (int i = 0; i < 3; ++i) simulation.step();
  const auto n_steps = static_cast<int>(std::max<std::size_t>(10, 10'000'000 / n_contacts));
  const double begin = processor_seconds();
  for (int i = 0; i < n_steps; ++i) simulation.step();
  return (processor_seconds() - begin) / n_steps;
}

void growth(benchmark::State& run) {
  for ([[maybe_unused]] auto _ : run) {
    const double memory = resident_memory();
    const double begin = processor_seconds();
    Simulation simulation = settling_lattice(static_cast<std::size_t>(run.range(0)));
    run.counters["set_up"] = processor_seconds() - begin;
    run.counters["peak_memory"] = peak_memory();
    const auto n_contacts = simulation.state().particle_contacts.size();
    run.counters["n_contacts"] = static_cast<double>(n_contacts);
    run.counters["per_item"] = step_time(simulation, n_contacts) / static_cast<double>(n_contacts);
    run.counters["memory"] = (resident_memory() - memory) / static_cast<double>(n_contacts);
    run.counters["rebuild"] = rebuild_time(simulation);
  }
}
BENCHMARK(growth)
    ->ArgName("particles")
    ->Arg(1'000)
    ->Arg(3'000)
    ->Arg(10'000)
    ->Arg(30'000)
    ->Arg(100'000)
    ->Arg(300'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace ligament::benchmarks
