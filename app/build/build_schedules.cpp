#include "build/build_schedules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ligament {
namespace {

/// What is wrong with a schedule; nothing if it is right. `name` is that of its values.
std::string complaint(const std::vector<double>& times, const std::vector<double>& values, const char* name) {
  if (times.size() != values.size()) {
    return fmt::format("'time' has {} items and '{}' {}: give one for each time", times.size(), name, values.size());
  }
  if (times.size() < 2) return "'time' needs at least two items";
  if (times.front() != 0.0) return fmt::format("'time' must begin with 0 s, not {} s", times.front());
  const auto late = std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); });
  if (late == times.end()) return {};
  return fmt::format("'time' must ascend, but {} s follows {} s", *(late + 1), *late);
}

PiecewiseLinear checked(Case& input, const std::vector<double>& times, const std::vector<double>& values,
                        const std::string& error, const TableView& view) {
  if (error.empty()) return {times, values};
  input.file.add_error(input.file.position(view, "schedule"), fmt::format("{} in 'schedule' {}", error, view.where()));
  return {};
}

}  // namespace

PiecewiseLinear build_schedule(Case& input, const MotionTable& table, const TableView& view) {
  const MotionSchedule& schedule = table.schedule;
  std::string error = complaint(schedule.time, schedule.displacement, "displacement");
  if (error.empty() && schedule.displacement.front() != 0.0) {
    error = fmt::format("'displacement' must begin with 0 m, not {} m", schedule.displacement.front());
  }
  if (error.empty() && (table.rise_time > 0.0 || table.stop_time)) {
    error = "there are times: leave 'rise_time' and 'stop_time' out, or the times";
  }
  return checked(input, schedule.time, schedule.displacement, error, view);
}

PiecewiseLinear build_schedule(Case& input, const LoadTable& table, const TableView& view) {
  const LoadSchedule& schedule = table.schedule;
  std::string error = complaint(schedule.time, schedule.share, "share");
  if (error.empty() && table.rise_time > 0.0) error = "there are times: leave 'rise_time' out, or the times";
  return checked(input, schedule.time, schedule.share, error, view);
}

}  // namespace ligament
