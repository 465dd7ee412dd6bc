#include "ensemble/ensemble_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "ensemble/plan_file.hpp"
#include "io/atomic_file.hpp"
#include "run/run_directory.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;

constexpr const char* plan_file = "ensemble_plan.json";

bool is_ensemble(const fs::path& path) { return fs::is_regular_file(path / plan_file); }

void check_room(const fs::path& path) {
  if (!fs::exists(path) || is_ensemble(path) || (fs::is_directory(path) && fs::is_empty(path))) return;
  throw InputError(fmt::format("{}: exists and is no ensemble; choose another with --output", path.string()));
}

/// Removes the runs of an ensemble, their checkpoints, and what it has written itself.
void remove_ensemble(const fs::path& path) {
  for (const EnsembleMember& member : members_of(read_plan(path / plan_file))) {
    if (!fs::exists(path / member.run)) continue;
    RunDirectory run = RunDirectory::open(path / member.run);
    run.set_aside();
    run.remove();
  }
  fs::remove_all(path);
}

void check_same(const fs::path& path, const EnsembleRequest& request) {
  const std::string what = difference(read_plan(path / plan_file), request);
  if (what.empty()) return;
  throw InputError(
      fmt::format("{}: holds an ensemble of another case: {}; choose another folder with --output, or "
                  "--overwrite it",
                  path.string(), what));
}

}  // namespace

EnsembleDirectory::EnsembleDirectory(const fs::path& path, const EnsembleRequest& request, bool overwrite) {
  try {
    check_room(path);
    lock(path);
    if (is_ensemble(path) && overwrite) {
      remove_ensemble(path);
      lock(path);
    }
    if (is_ensemble(path)) check_same(path, request);
    write_atomically(path / plan_file, plan_text(request));
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("{}: cannot make the folder: {}", path.string(), error.code().message()));
  }
}

void EnsembleDirectory::lock(const fs::path& path) {
  fs::create_directories(path);
  lock_.emplace(path, O_RDONLY | O_DIRECTORY);
  if (lock_->try_lock()) return;
  throw InputError(fmt::format("{}: another process is at work on this ensemble", path.string()));
}

}  // namespace ligament
