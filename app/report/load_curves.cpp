#include "report/load_curves.hpp"

#include <algorithm>

namespace ligament {
namespace {

bool has_column(const CsvContent& table, const std::string& name) {
  return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
}

}  // namespace

std::vector<std::string> gauges_of(const CsvContent& history) {
  const auto begin = static_cast<std::ptrdiff_t>(history.column_index("time_s")) + 1;
  const auto end = static_cast<std::ptrdiff_t>(history.column_index("n_broken"));
  return {history.columns.begin() + begin, history.columns.begin() + end};
}

LoadCurves load_curves(const CsvContent& history) {
  const std::vector<std::string> gauges = gauges_of(history);
  const auto first_in = [&](const char* unit) {
    const auto found =
        std::find_if(gauges.begin(), gauges.end(), [&](const auto& name) { return name.ends_with(unit); });
    return found == gauges.end() ? std::string() : *found;
  };
  LoadCurves curves{has_column(history, "load_N") ? "load_N" : first_in("_N"), {}};
  for (const char* name : {"deflection_m", "cmod_m", "cmsd_m"}) {
    if (has_column(history, name)) curves.displacements.emplace_back(name);
  }
  curves.are_named = !curves.displacements.empty() && !curves.load.empty();
  if (curves.displacements.empty() && !first_in("_m").empty()) curves.displacements.push_back(first_in("_m"));
  if (curves.load.empty()) curves.displacements.clear();
  return curves;
}

}  // namespace ligament
