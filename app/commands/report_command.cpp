#include <fmt/format.h>

#include <memory>

#include "commands/commands.hpp"
#include "report/report.hpp"
#include "run/run_directory.hpp"

namespace ligament {
namespace {

struct Options {
  std::string path;
  ReportOptions report;
};

ExitCode report(Options options) {
  const RunDirectory directory = RunDirectory::open(options.path);
  const Case input = read_case(directory.file("case.toml"), directory.overrides(), directory.copies());
  for (const auto& [notch, view] : input.notches) {
    options.report.notches.push_back({to_vector(notch.from), to_vector(notch.to)});
  }
  fmt::print("report: {}\n", write_report(directory.path(), options.report).string());
  return ExitCode::done;
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "curves and a picture of the cracks of a run, with its numbers");
  command->add_option("run_directory", options->path, "directory of the run")->required()->type_name("DIR");
  command->add_option("--scale", options->report.scale, "factor on displacements in the picture (default: 1)");
  command->add_option("--step", options->report.step, "output of fields to draw (default: the last one)");
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace ligament
