#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <optional>

#include "commands/commands.hpp"
#include "commands/common_options.hpp"
#include "core/parallel.hpp"
#include "io/case_overrides.hpp"
#include "run/case_changes.hpp"
#include "run/run_report.hpp"
#include "run/runner.hpp"
#include "run/signals.hpp"
#include "version.hpp"

namespace ligament {
namespace {

struct RunOptions {
  std::string case_path;
  std::string output;
  bool overwrite = false;
  bool quiet = false;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> stop_after_steps;
  int n_threads = 1;
};

std::filesystem::path checkpoint_parent(const Case& input, const std::filesystem::path& case_path) {
  if (!input.checkpoint.folder) return "checkpoints";
  return case_path.parent_path() / *input.checkpoint.folder;
}

void show_banner(Console& console, const Case& input, const BuiltSimulation& built) {
  const int n_threads = threads().count;
  console.line(fmt::format("ligament {} ({}), {} thread{}: {}", program_version(), program_build(), n_threads,
                           n_threads == 1 ? "" : "s", input.file.file_name()));
  for (const std::string& line : describe(input, built)) console.line(line);
  for (const std::string& warning : built.warnings) console.warning(warning);
}

/// The log of a run tells how it failed, too.
ExitCode with_log(Console& console, const RunDirectory& directory, const Action& action) {
  try {
    return action();
  } catch (const FileError& error) {
    const std::string text =
        fmt::format("{}\nwhen that is mended, 'ligament resume {}' goes on", error.what(), directory.path().string());
    console.log(text);
    throw FileError(text);
  } catch (const std::bad_alloc&) {
    const std::string text =
        fmt::format("out of memory\nwith more of it, 'ligament resume {}' goes on", directory.path().string());
    console.log(text);
    throw Error(ExitCode::wrong_input, text);
  } catch (const Error& error) {
    console.log(error.what());
    throw;
  }
}

ExitCode run(const RunOptions& options) {
  threads().count = options.n_threads;
  const std::filesystem::path case_path = options.case_path;
  const std::filesystem::path output = options.output.empty() ? std::filesystem::path("results") / case_path.stem()
                                                              : std::filesystem::path(options.output);
  Case input = read_case(case_path, options.overrides);
  // Everything that can be wrong with the input is known before anything is written.
  BuiltSimulation built = build_simulation(input);
  install_signal_handlers();
  const RunDirectory directory =
      RunDirectory::create(output, input, options.overrides, checkpoint_parent(input, case_path), options.overwrite);
  Console console(options.quiet);
  console.open_log(directory.file("run.log"));
  show_banner(console, input, built);
  Runner runner(input, built, directory, console);
  runner.stop_at(options.stop_after_steps);
  return with_log(console, directory, [&] { return runner.start(); });
}

struct ResumeOptions {
  std::string directory;
  bool quiet = false;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> until_step;
  int n_threads = 1;
};

/// The overrides of a run joined by those of a resume, which replace earlier ones of the same key.
std::vector<std::string> joined_overrides(std::vector<std::string> overrides, const std::vector<std::string>& more) {
  for (const std::string& override : more) {
    const std::string key = parse_override(override).key;
    std::erase_if(overrides, [&key](const std::string& known) { return parse_override(known).key == key; });
    overrides.push_back(override);
  }
  return overrides;
}

ExitCode resume(const ResumeOptions& options) {
  threads().count = options.n_threads;
  RunDirectory directory = RunDirectory::open(options.directory);
  directory.lock();
  const std::filesystem::path case_path = directory.file("case.toml");
  const std::vector<std::string> overrides = joined_overrides(directory.overrides(), options.overrides);
  Case input = read_case(case_path, overrides, directory.copies());
  const bool is_changed = !options.overrides.empty();
  if (is_changed) {
    const Case before = read_case(case_path, directory.overrides(), directory.copies());
    require_same_run(before.file.resolved_text(), input.file.resolved_text());
  }
  BuiltSimulation built = build_simulation(input);
  if (is_changed) directory.change_overrides(overrides, input);
  Console console(options.quiet);
  console.open_log(directory.file("run.log"));
  show_banner(console, input, built);
  install_signal_handlers();
  Runner runner(input, built, directory, console);
  runner.stop_at(options.until_step);
  return with_log(console, directory, [&] { return runner.resume(); });
}

CLI::Range steps_range() { return CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()); }

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "run a case");
  command->add_option("case", options->case_path, "case file (TOML)")->required()->type_name("FILE");
  command->add_option("--output", options->output, "run directory; default results/<case>")->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "replace the run that is in the run directory");
  command->add_flag("--quiet", options->quiet, "say nothing but warnings and errors");
  add_set_option(*command, options->overrides);
  command->add_option("--stop-after-steps", options->stop_after_steps, "stop at this step, with a checkpoint")
      ->check(steps_range());
  add_threads_option(*command, options->n_threads);
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

void add_resume_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ResumeOptions>();
  CLI::App* command = app.add_subcommand("resume", "go on from the newest good checkpoint, to the same bits");
  command->add_option("run_directory", options->directory, "directory of the run")->required()->type_name("DIR");
  command->add_flag("--quiet", options->quiet, "say nothing but warnings and errors");
  add_set_option(*command, options->overrides,
                 "key=value from now on, for what is written and when the run ends; repeatable");
  command->add_option("--until-step", options->until_step, "stop at this step, with a checkpoint")
      ->check(steps_range());
  add_threads_option(*command, options->n_threads);
  command->callback([options, &action] { action = [options] { return resume(*options); }; });
}

}  // namespace ligament
