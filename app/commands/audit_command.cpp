#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "run/run_directory.hpp"

namespace ligament {
namespace {

ExitCode audit(const std::string& path) {
  const RunDirectory directory = RunDirectory::open(path);
  const CsvContent energy = read_csv(directory.file("energy.csv"));
  if (energy.rows.empty()) throw FileError(fmt::format("{}: has no rows", directory.file("energy.csv").string()));
  fmt::print("energy ledger at step {}\n", energy.rows.back().front());
  for (std::size_t column = 2; column < energy.columns.size(); ++column) {
    fmt::print("  {:<24} {:>16}\n", energy.columns[column], energy.rows.back()[column]);
  }
  if (!std::filesystem::exists(directory.file("summary.json"))) {
    fmt::print("no verdict: the run has not ended\n");
    return ExitCode::done;
  }
  try {
    const auto summary = nlohmann::json::parse(read_file(directory.file("summary.json")));
    const auto verdict = summary.at("audit").get<std::string>();
    fmt::print("largest error {:.3g}, tolerance {:.3g}: {}\n", summary.at("energy_error").get<double>(),
               summary.at("audit_tolerance").get<double>(), verdict);
    return verdict == "passed" ? ExitCode::done : ExitCode::audit_failed;
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", directory.file("summary.json").string(), error.what()));
  }
}

}  // namespace

void add_audit_command(CLI::App& app, Action& action) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("audit", "the energy ledger of a run and its verdict");
  command->add_option("run_directory", *path, "directory of the run")->required()->type_name("DIR");
  command->callback([path, &action] { action = [path] { return audit(*path); }; });
}

}  // namespace ligament
