#include <chrono>
#include <filesystem>

#include "core/fields.hpp"
#include "core/state_hash.hpp"
#include "counters.hpp"
#include "io/checkpoint_store.hpp"
#include "io/state_archive.hpp"
#include "lattice.hpp"

namespace ligament::benchmarks {
namespace {

namespace fs = std::filesystem;

std::size_t bytes_of(const State& state) {
  std::size_t n_bytes = 0;
  visit_fields(state, [&]<class T>(const std::string&, const T& field, FieldRole) {
    if constexpr (requires { field.data(); }) n_bytes += field.size() * sizeof(field[0]);
  });
  return n_bytes;
}

/// Seconds of one step, the mean of some.
double step_time(Simulation& simulation) {
  constexpr int n_steps = 20;
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < n_steps; ++i) simulation.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / n_steps;
}

/// A checkpoint as a run writes it, older ones looked at and removed. Counters: the time of so many steps, and the size
/// of the file over that of the fields in it.
void checkpoint(benchmark::State& run) {
  Simulation simulation = settling_lattice(static_cast<std::size_t>(run.range(0)));
  const double step = step_time(simulation);
  const State& state = simulation.state();
  const fs::path folder = fs::temp_directory_path() / "ligament_benchmark_checkpoints";
  CheckpointStore store(folder, "benchmark", 3);
  CheckpointHeader header;
  header.step = state.clock.step;
  header.array_lengths = array_lengths(state);
  fs::path path;
  std::string archive;
  const auto begin = std::chrono::steady_clock::now();
  for ([[maybe_unused]] auto _ : run) {
    ++header.step;
    header.state_hash = state_hash(state);
    archive = save_state(state, std::move(archive));
    path = store.write(header, archive);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double n_written = static_cast<double>(run.iterations());
  run.counters["steps"] = seconds / n_written / step;
  run.counters["size_over_data"] = static_cast<double>(fs::file_size(path)) / static_cast<double>(bytes_of(state));
  count_items(run, "bytes", bytes_of(state));
  fs::remove_all(folder);
}
BENCHMARK(checkpoint)->ArgName("particles")->Arg(10'000)->Arg(100'000)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ligament::benchmarks
