#include <fmt/format.h>

#include <memory>

#include "build/build_simulation.hpp"
#include "commands/commands.hpp"
#include "commands/common_options.hpp"
#include "run/run_report.hpp"

namespace ligament {
namespace {

struct CheckOptions {
  std::string case_path;
  std::vector<std::string> overrides;
};

ExitCode check(const CheckOptions& options) {
  Case input = read_case(options.case_path, options.overrides);
  const BuiltSimulation built = build_simulation(input);
  for (const std::string& line : describe(input, built)) fmt::print("{}\n", line);
  fmt::print("memory: {:.1f} MB\n",
             static_cast<double>(memory_of(built.simulation.model(), built.simulation.state())) / 1e6);
  for (const std::string& warning : built.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("OK: 0 errors, {} warnings\n", built.warnings.size());
  return ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "build everything, run nothing");
  command->add_option("case", options->case_path, "case file (TOML)")->required()->type_name("FILE");
  add_set_option(*command, options->overrides);
  command->callback([options, &action] { action = [options] { return check(*options); }; });
}

}  // namespace ligament
