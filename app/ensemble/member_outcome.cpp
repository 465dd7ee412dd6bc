#include "ensemble/member_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "report/load_curves.hpp"
#include "run/run_directory.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;

using Numbers = std::vector<std::pair<std::string, double>>;

ExitCode code_of(const std::string& ended, const std::string& audit) {
  if (ended == "not_converged") return ExitCode::not_converged;
  if (ended == "diverged") return ExitCode::diverged;
  if (ended == "interrupted") return ExitCode::interrupted;
  return audit == "passed" ? ExitCode::done : ExitCode::audit_failed;
}

void add_peaks(const CsvContent& history, Numbers& numbers) {
  for (const std::string& gauge : gauges_of(history)) {
    const std::vector<double> values = history.numbers(gauge);
    if (!values.empty()) numbers.emplace_back("peak_" + gauge, *std::max_element(values.begin(), values.end()));
  }
}

void add_results(const nlohmann::ordered_json& summary, Numbers& numbers) {
  // The summary has seen all states of equilibrium, the table only those that were written.
  const auto peak =
      std::find_if(numbers.begin(), numbers.end(), [](const auto& n) { return n.first == "peak_load_N"; });
  if (peak != numbers.end()) peak->second = summary.value("peak_load_N", peak->second);
  for (const auto& [name, value] : summary.at("results").items()) {
    if (value.is_number()) numbers.emplace_back(name, value.get<double>());
  }
}

std::string relative_to_case(const fs::path& case_path, const std::string& file) {
  return (case_path.parent_path() / file).string();
}

}  // namespace

MemberOutcome read_outcome(const fs::path& run) {
  MemberOutcome outcome;
  if (!fs::exists(run / "run.json")) return outcome;
  const fs::path path = run / "summary.json";
  outcome.ended = "unfinished";
  if (!fs::exists(path)) return outcome;
  try {
    const auto summary = nlohmann::ordered_json::parse(read_file(path));
    outcome.ended = summary.at("ended").get<std::string>();
    outcome.is_final = outcome.ended != "interrupted" && outcome.ended != "stopped";
    outcome.audit = summary.at("audit").get<std::string>();
    outcome.exit_code = static_cast<int>(code_of(outcome.ended, outcome.audit));
    outcome.steps = summary.at("steps").get<std::int64_t>();
    outcome.energy_error = summary.at("energy_error").is_number() ? summary.at("energy_error").get<double>() : NAN;
    outcome.numbers.emplace_back("n_broken", summary.at("n_broken").get<double>());
    add_peaks(read_csv(run / "history.csv"), outcome.numbers);
    add_results(summary, outcome.numbers);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", path.string(), error.what()));
  }
  return outcome;
}

void check_member(const fs::path& run, const EnsembleMember& member, const fs::path& case_path,
                  const std::string& case_text) {
  if (!fs::exists(run)) return;
  const RunDirectory directory = RunDirectory::open(run);
  if (directory.overrides() != member.overrides || read_file(directory.file("case.toml")) != case_text) {
    throw InputError(
        fmt::format("{}: holds another run than this ensemble's; move it away or remove it", run.string()));
  }
  for (const auto& [file, copy] : directory.copies()) {
    const std::string original = relative_to_case(case_path, file);
    if (read_file(original) == read_file(copy)) continue;
    throw InputError(fmt::format("{}: is no longer what {} was made with, of which {} is a copy", original,
                                 run.string(), copy.string()));
  }
}

}  // namespace ligament
