#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/error.hpp"

namespace ligament {

/// Set by the command that the command line names; what it returns goes to the shell.
using Action = std::function<ExitCode()>;

/// Each adds its command with its options, and sets `action` when it is chosen.
void add_run_command(CLI::App& app, Action& action);
void add_resume_command(CLI::App& app, Action& action);
void add_check_command(CLI::App& app, Action& action);
void add_generate_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_audit_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_ensemble_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_documentation_commands(CLI::App& app, Action& action);

}  // namespace ligament
