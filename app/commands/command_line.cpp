#include "commands/command_line.hpp"

#include <cstdio>
#include <exception>
#include <new>

#include "commands/commands.hpp"
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
  add_compare_command(app, action);
  add_audit_command(app, action);
  add_info_command(app, action);
  add_documentation_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors; all others are wrong input here, whatever the library calls them.
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::wrong_input);
  }
  return carry_out(action);
}

}  // namespace ligament
