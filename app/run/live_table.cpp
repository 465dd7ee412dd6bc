#include "run/live_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ligament {
namespace {

/// More gauges than this would not fit on a line.
constexpr std::size_t most_gauges = 4;

}  // namespace

LiveTable::LiveTable(const Case& input, const std::vector<Gauge>& gauges, Console& console)
    : last_step_(input.solver.max_steps), console_(console) {
  for (std::size_t i = 0; i < std::min(gauges.size(), most_gauges); ++i) columns_.push_back(gauges[i].column);
}

void LiveTable::show_header() {
  std::string line = fmt::format("{:>10}", "step");
  for (const std::string& column : columns_) line += fmt::format("  {:>12}", column);
  console_.line(line + fmt::format("  {:>8}  {:>10}  {:>10}", "broken", "unbalance", "energy err"));
}

void LiveTable::show(const HistoryRow& row) {
  std::string line = fmt::format("{:>10}", row.step);
  for (std::size_t i = 0; i < columns_.size(); ++i) line += fmt::format("  {:>12.5g}", row.gauges[i]);
  console_.line(
      line + fmt::format("  {:>8}  {:>10.3g}  {:>10.3g}", row.n_broken, row.unbalanced_force_ratio, row.energy_error));
  last_row_ = row;
}

void LiveTable::show_progress(std::int64_t step) {
  if (!console_.shows_progress()) return;
  const auto now = std::chrono::steady_clock::now();
  if (first_step_ < 0) {
    first_step_ = step;
    begin_ = shown_ = now;
  }
  if (now - shown_ < std::chrono::milliseconds(250)) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double left = elapsed / static_cast<double>(step - first_step_) * static_cast<double>(last_step_ - step);
  std::string text = fmt::format("step {} of at most {}, {:.0f} s left at most", step, last_step_, left);
  if (!columns_.empty() && !last_row_.gauges.empty()) {
    text += fmt::format(", {} = {:.4g}", columns_[0], last_row_.gauges[0]);
  }
  console_.progress(text + fmt::format(", {} broken, energy error {:.1e}", last_row_.n_broken, last_row_.energy_error));
}

}  // namespace ligament
