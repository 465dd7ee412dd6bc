#include "ensemble/ensemble_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ensemble/statistics.hpp"
#include "io/atomic_file.hpp"
#include "version.hpp"

namespace ligament {
namespace {

using Json = nlohmann::ordered_json;

/// Names of all numbers, in the order in which runs first have them.
std::vector<std::string> number_names(const std::vector<EnsembleRow>& rows) {
  std::vector<std::string> names;
  for (const EnsembleRow& row : rows) {
    for (const auto& [name, value] : row.outcome.numbers) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

double number_of(const MemberOutcome& outcome, const std::string& name) {
  const auto found = std::find_if(outcome.numbers.begin(), outcome.numbers.end(),
                                  [&](const auto& number) { return number.first == name; });
  return found == outcome.numbers.end() ? std::nan("") : found->second;
}

std::string table_of(const std::vector<EnsembleRow>& rows) {
  const std::vector<std::string> names = number_names(rows);
  std::string text = "run,seed";
  for (const SweptValue& value : rows.front().values) text += "," + value.column;
  text += ",ended,exit_code,steps,energy_error,audit";
  for (const std::string& name : names) text += "," + name;
  for (const auto& [member, outcome, values] : rows) {
    text += fmt::format("\n{},{}", member.run, member.seed ? fmt::format("{}", *member.seed) : "");
    for (const SweptValue& value : values) text += "," + value.cell;
    text += fmt::format(",{},{},{},{},{}", outcome.ended, outcome.exit_code, outcome.steps, outcome.energy_error,
                        outcome.audit);
    for (const std::string& name : names) text += fmt::format(",{}", number_of(outcome, name));
  }
  return text + "\n";
}

Json statistics_of_group(const std::vector<EnsembleRow>& rows) {
  Json numbers = Json::object();
  for (const std::string& name : number_names(rows)) {
    std::vector<double> values;
    for (const EnsembleRow& row : rows) {
      const double value = number_of(row.outcome, name);
      if (row.outcome.is_done() && std::isfinite(value)) values.push_back(value);
    }
    if (values.empty()) continue;
    const Statistics of = statistics_of(values);
    numbers[name] = {{"n", of.n},
                     {"mean", of.mean},
                     {"standard_deviation", of.standard_deviation},
                     {"min", of.min},
                     {"max", of.max}};
  }
  return numbers;
}

std::size_t n_done(const std::vector<EnsembleRow>& rows) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const EnsembleRow& row) { return row.outcome.is_done(); }));
}

}  // namespace

std::vector<std::vector<EnsembleRow>> groups_of(const std::vector<EnsembleRow>& rows) {
  std::vector<std::vector<EnsembleRow>> groups;
  for (const EnsembleRow& row : rows) {
    if (groups.empty() || groups.back().front().member.group != row.member.group) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

void write_ensemble_tables(const std::filesystem::path& folder, const std::vector<EnsembleRow>& rows) {
  Json groups = Json::array();
  for (const std::vector<EnsembleRow>& group : groups_of(rows)) {
    Json values = Json::object();
    for (const SweptValue& value : group.front().values) values[value.column] = value.cell;
    groups.push_back({{"values", values},
                      {"n_runs", group.size()},
                      {"n_done", n_done(group)},
                      {"numbers", statistics_of_group(group)}});
  }
  const Json json{
      {"version", program_version()}, {"n_runs", rows.size()}, {"n_done", n_done(rows)}, {"groups", groups}};
  write_atomically(folder / "ensemble.csv", table_of(rows));
  write_atomically(folder / "ensemble.json", json.dump(2) + "\n");
}

}  // namespace ligament
