#include "commands/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

#include "commands/commands.hpp"
#include "core/closest_name.hpp"
#include "run/signals.hpp"
#include "version.hpp"

namespace ligament {
namespace {

int tell(const std::string& message, ExitCode code) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return static_cast<int>(code);
}

int carry_out(const Action& action) {
  try {
    return static_cast<int>(action());
  } catch (const Error& error) {
    return tell(error.what(), error.code());
  } catch (const std::bad_alloc&) {
    return tell("out of memory", ExitCode::wrong_input);
  } catch (const std::exception& error) {
    return tell(std::string("internal error: ") + error.what(), ExitCode::diverged);
  }
}

/// What is wrong with the word in the place of a command; empty if it is one. The library's message does not name it.
std::string complaint_about_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (word.empty()) return fmt::format("a command is missing (there are: {})", quoted_list(names));
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return {};
  return fmt::format("there is no command '{}' (there are: {}){}", word, quoted_list(names), did_you_mean(word, names));
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app("ligament: hybrid discrete element/finite element program for fracture analysis", "ligament");
  app.set_version_flag("--version",
                       "ligament " + program_version() + " (" + program_build() + ", " + program_compiler() + ")");
  app.require_subcommand(1);
  Action action;
  add_run_command(app, action);
  add_resume_command(app, action);
  add_check_command(app, action);
  add_generate_command(app, action);
  add_compare_command(app, action);
  add_audit_command(app, action);
  add_report_command(app, action);
  add_ensemble_command(app, action);
  add_info_command(app, action);
  add_documentation_commands(app, action);
  if (const std::string complaint = complaint_about_command(app, argc > 1 ? argv[1] : ""); !complaint.empty()) {
    return tell(complaint, ExitCode::wrong_input);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors; all others are wrong input here, whatever the library calls them.
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::wrong_input);
  }
  ignore_file_size_signal();
  return carry_out(action);
}

}  // namespace ligament
