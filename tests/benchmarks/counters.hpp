#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>

namespace ligament::benchmarks {

/// Reports how many items (contacts, elements, …) an iteration went through, and the time of one of them (s).
inline void count_items(benchmark::State& run, const std::string& items, std::size_t count) {
  using benchmark::Counter;
  run.counters["n_" + items] = static_cast<double>(count);
  run.counters["per_item"] = Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

}  // namespace ligament::benchmarks
