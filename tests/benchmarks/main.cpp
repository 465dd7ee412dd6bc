#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "whole_step.hpp"

/// benchmarks [options of Google Benchmark] [CASE.toml…]: without a case, the steps of the columns R1 and H1.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  std::vector<std::string> cases(argv + 1, argv + argc);
  if (cases.empty()) {
    cases = {LIGAMENT_SOURCE_DIR "/config/column_random_r1.toml",
             LIGAMENT_SOURCE_DIR "/config/column_hexagonal_h1.toml"};
  }
  for (const std::string& path : cases) ligament::benchmarks::register_case_step(path);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
