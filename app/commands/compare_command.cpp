#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands/commands.hpp"
#include "io/checkpoint_store.hpp"
#include "io/state_archive.hpp"
#include "run/compare_states.hpp"
#include "run/run_directory.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;

/// The checkpoint itself, or the newest good one of a run directory.
Checkpoint find_checkpoint(const fs::path& path) {
  if (!fs::exists(path)) throw InputError(fmt::format("{}: there is no such file or directory", path.string()));
  if (!fs::is_directory(path)) return read_checkpoint(path);
  const RunDirectory directory = RunDirectory::open(path);
  const CheckpointStore store(directory.checkpoint_folder(), directory.run_id(), 1);
  auto checkpoint = store.newest_good([](const fs::path& bad, const std::string& reason) {
    fmt::print(stderr, "warning: {}: {}; taking an earlier one\n", bad.string(), reason);
  });
  if (!checkpoint) throw FileError(fmt::format("{}: the run has no good checkpoint", path.string()));
  return *std::move(checkpoint);
}

ExitCode compare(const std::string& path_a, const std::string& path_b) {
  const Checkpoint a = find_checkpoint(path_a);
  const Checkpoint b = find_checkpoint(path_b);
  const auto difference = first_difference(load_unknown_state(a.payload, a.header.array_lengths),
                                           load_unknown_state(b.payload, b.header.array_lengths));
  if (!difference) {
    fmt::print("identical at step {} (state hash {})\n", a.header.step, a.header.state_hash);
    return ExitCode::done;
  }
  fmt::print("first difference (step {} against step {}): {}\n", a.header.step, b.header.step, *difference);
  return ExitCode::comparison_differs;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  auto paths = std::make_shared<std::pair<std::string, std::string>>();
  CLI::App* command = app.add_subcommand("compare", "first difference between two runs or checkpoints");
  command->add_option("a", paths->first, "run directory or checkpoint")->required()->type_name("PATH");
  command->add_option("b", paths->second, "run directory or checkpoint")->required()->type_name("PATH");
  command->callback([paths, &action] { action = [paths] { return compare(paths->first, paths->second); }; });
}

}  // namespace ligament
