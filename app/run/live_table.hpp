#pragma once

#include <chrono>

#include "run/console.hpp"
#include "run/results.hpp"

namespace ligament {

/// What a run shows while it goes on: a line for each output row, and on a terminal how far it is.
class LiveTable {
 public:
  LiveTable(const Case& input, const std::vector<Gauge>& gauges, Console& console);

  void show_header();
  void show(const HistoryRow& row);
  /// Called at every step; shows progress a few times a second.
  void show_progress(std::int64_t step);

 private:
  const std::int64_t last_step_;
  std::vector<std::string> columns_;
  Console& console_;
  std::int64_t first_step_ = -1;
  HistoryRow last_row_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace ligament
