#include <benchmark/benchmark.h>

#include <vector>

#include "counters.hpp"

/// A chain of multiplications and additions that no change of the program touches: the times of all other benchmarks
/// are read against it, so that a slower machine does not look like a slower program.
namespace {

using namespace ligament::benchmarks;

void calibration(benchmark::State& run) {
  constexpr std::size_t n_values = 16384;
  std::vector<double> values(n_values);
  for (std::size_t i = 0; i < n_values; ++i) values[i] = 1e-3 * static_cast<double>(i % 97);
  for ([[maybe_unused]] auto _ : run) {
    double x = 0.5;
    for (const double value : values) x = 0.999 * x + value;
    benchmark::DoNotOptimize(x);
  }
  count_items(run, "values", n_values);
}
BENCHMARK(calibration)->Unit(benchmark::kMicrosecond);

}  // namespace
