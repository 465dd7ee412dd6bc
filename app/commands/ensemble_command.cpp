#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>

#include "build/check_case.hpp"
#include "commands/commands.hpp"
#include "commands/common_options.hpp"
#include "ensemble/ensemble_curves.hpp"
#include "ensemble/ensemble_directory.hpp"
#include "ensemble/ensemble_runs.hpp"
#include "run/console.hpp"

namespace ligament {
namespace {

struct EnsembleOptions {
  std::string case_path;
  std::string output;
  std::string seeds;
  std::vector<std::string> sweeps;
  std::vector<std::string> overrides;
  bool overwrite = false;
  bool quiet = false;
  int n_jobs = 2;
  int n_threads = 1;
};

EnsembleRequest request_of(const EnsembleOptions& options) {
  EnsembleRequest request;
  request.case_path = options.case_path;
  request.overrides = options.overrides;
  if (!options.seeds.empty()) request.seeds = parse_seeds(options.seeds);
  for (const std::string& text : options.sweeps) request.sweeps.push_back(parse_sweep(text));
  if (request.seeds.empty() && request.sweeps.empty()) {
    throw InputError("an ensemble needs --seeds, such as --seeds 1:4, or --sweep key=value,value,…");
  }
  return request;
}

void check_seed(const Case& input) {
  const bool has_seed = std::any_of(input.zones.begin(), input.zones.end(),
                                    [](const auto& zone) { return zone.table.generator->depends_on_seed(); });
  if (has_seed) return;
  throw InputError(fmt::format("{}: no zone of the case depends on a seed, so --seeds would make the same run again",
                               input.file.file_name()));
}

/// Reads and checks the case of every member, before anything is written.
std::vector<EnsembleRow> checked_rows(EnsembleRequest& request) {
  std::vector<EnsembleRow> rows;
  for (EnsembleMember& member : members_of(request)) {
    Case input = read_case(request.case_path, member.overrides);
    if (member.seed) check_seed(input);
    check_case(input);
    request.case_text = input.file.text();
    std::vector<SweptValue> values = swept_values(request.sweeps, member, input.file.resolved_text());
    rows.push_back({std::move(member), {}, std::move(values)});
  }
  return rows;
}

void check_runs(const RunSettings& settings, const EnsembleRequest& request, const std::vector<EnsembleRow>& rows) {
  for (const EnsembleRow& row : rows) {
    check_member(settings.folder / row.member.run, row.member, settings.case_path, request.case_text);
  }
}

void show_table(const std::vector<EnsembleRow>& rows, Console& console) {
  std::size_t width = 3;
  for (const EnsembleRow& row : rows) width = std::max(width, row.member.run.size());
  console.line(fmt::format("{:<{}}  {:<13}  {:>8}  {:>10}  {:<6}  {:>4}", "run", width, "ended", "step", "energy err",
                           "audit", "exit"));
  for (const auto& [member, outcome, values] : rows) {
    console.line(fmt::format("{:<{}}  {:<13}  {:>8}  {:>10.3g}  {:<6}  {:>4}", member.run, width, outcome.ended,
                             outcome.steps, outcome.energy_error, outcome.audit, outcome.exit_code));
  }
}

/// That of the first run that is not done.
ExitCode exit_code_of(const std::vector<EnsembleRow>& rows) {
  const auto failed =
      std::find_if(rows.begin(), rows.end(), [](const EnsembleRow& row) { return !row.outcome.is_done(); });
  return failed == rows.end() ? ExitCode::done : static_cast<ExitCode>(failed->outcome.exit_code);
}

void write_curves(const std::filesystem::path& folder, const std::vector<EnsembleRow>& rows, Console& console) {
  try {
    if (!write_ensemble_curves(folder, rows)) console.line("no mean curve: the runs share no load over a displacement");
  } catch (const FileError& error) {
    // The tables are there; a picture can be made later, by the same call.
    console.warning(error.what());
  }
}

ExitCode ensemble(const EnsembleOptions& options) {
  EnsembleRequest request = request_of(options);
  std::vector<EnsembleRow> rows = checked_rows(request);
  const std::filesystem::path case_path = options.case_path;
  const std::filesystem::path folder = options.output.empty() ? std::filesystem::path("results") / case_path.stem()
                                                              : std::filesystem::path(options.output);
  const RunSettings settings{folder, case_path, options.n_jobs, options.n_threads};
  const EnsembleDirectory directory(folder, request, options.overwrite);
  check_runs(settings, request, rows);
  Console console(options.quiet);
  const int signal = make_runs(settings, rows, console);
  if (signal != 0) {
    console.line("stopped; the same call goes on");
    return signal == SIGINT ? ExitCode::interrupted : ExitCode::terminated;
  }
  // The case file may have been edited under way.
  check_runs(settings, request, rows);
  write_ensemble_tables(folder, rows);
  write_curves(folder, rows, console);
  show_table(rows, console);
  console.line(fmt::format("results: {}", folder.string()));
  return exit_code_of(rows);
}

}  // namespace

void add_ensemble_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<EnsembleOptions>();
  CLI::App* command = app.add_subcommand("ensemble", "a case over seeds or values: all runs, mean and band; resumable");
  command->add_option("case", options->case_path, "case file (TOML)")->required()->type_name("FILE");
  command->add_option("--seeds", options->seeds, "seeds of the assemblies, such as 1:4 or 1:3,7")->type_name("SEEDS");
  command->add_option("--sweep", options->sweeps, "key=value,value,… taken in turn; several: all combinations")
      ->type_name("KEY=VALUES")
      ->take_all()
      ->allow_extra_args(false);
  add_set_option(*command, options->overrides);
  command->add_option("--output", options->output, "folder of the ensemble; default results/<case>")->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "replace the ensemble that is in the folder");
  command->add_option("--jobs", options->n_jobs, "runs at a time; default 2")->check(CLI::Range(1, 1024));
  add_threads_option(*command, options->n_threads);
  command->add_flag("--quiet", options->quiet, "say nothing but warnings and errors");
  command->callback([options, &action] { action = [options] { return ensemble(*options); }; });
}

}  // namespace ligament
