#include "run/run_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "version.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;

constexpr const char* identity_file = "run.json";

std::string new_run_id() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

/// A folder whose name is no name, such as "results/x/" or ".", is known by its full path.
fs::path normalized(const fs::path& path) {
  fs::path full = fs::absolute(path).lexically_normal();
  return full.has_filename() ? full : full.parent_path();
}

bool is_run(const fs::path& path) { return fs::is_directory(path) && fs::exists(path / identity_file); }

void check_room(const fs::path& path, bool overwrite) {
  if (!fs::exists(path) || (fs::is_directory(path) && fs::is_empty(path))) return;
  if (!is_run(path)) {
    throw InputError(fmt::format("{}: exists and is no run directory; choose another with --output", path.string()));
  }
  if (overwrite) return;
  throw InputError(fmt::format("{}: holds a run already; 'ligament resume {}' goes on with it, --overwrite removes it",
                               path.string(), path.string()));
}

/// Removes what check_room() has let pass.
void clear(const fs::path& path) {
  if (is_run(path)) {
    RunDirectory earlier = RunDirectory::open(path);
    earlier.lock();
    // Whatever run.json says, only a folder that bears the run's id is the run's own.
    const fs::path& checkpoints = earlier.checkpoint_folder();
    if (checkpoints.filename().string().ends_with("-" + earlier.run_id())) fs::remove_all(checkpoints);
  }
  fs::remove_all(path);
}

/// A folder that is removed unless it was given its final name.
class PartFolder {
 public:
  explicit PartFolder(fs::path path) : path_(std::move(path)) {}
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  ~PartFolder() {
    std::error_code already_failing;
    fs::remove_all(path_, already_failing);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

RunDirectory RunDirectory::create(const fs::path& path, const Case& input, const std::vector<std::string>& overrides,
                                  const fs::path& checkpoint_parent, bool overwrite) {
  RunDirectory run;
  try {
    run.path_ = normalized(path);
    check_room(run.path_, overwrite);
    run.run_id_ = new_run_id();
    run.case_name_ = input.file.file_name();
    run.overrides_ = overrides;
    run.checkpoint_folder_ =
        fs::absolute(checkpoint_parent) / fmt::format("{}-{}", run.path_.filename().string(), run.run_id_);

    const PartFolder part(fs::path(run.path_) += fmt::format(".{}.part", run.run_id_));
    fs::create_directories(part.path() / "fields");
    write_atomically(part.path() / "case.toml", input.file.text());
    write_atomically(part.path() / "case_resolved.toml", input.file.resolved_text());
    const nlohmann::ordered_json identity{{"program", "ligament"},  {"version", program_version()},
                                          {"run_id", run.run_id_},  {"case", run.case_name_},
                                          {"overrides", overrides}, {"checkpoints", run.checkpoint_folder_.string()}};
    write_atomically(part.path() / identity_file, identity.dump(2) + "\n");
    clear(run.path_);
    fs::rename(part.path(), run.path_);
    run.lock();
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("{}: cannot make the run directory: {}", path.string(), error.code().message()));
  }
  return run;
}

RunDirectory RunDirectory::open(const fs::path& path) {
  RunDirectory run;
  run.path_ = normalized(path);
  const fs::path identity_path = run.path_ / identity_file;
  if (!fs::is_regular_file(identity_path)) {
    throw InputError(fmt::format("{}: is no run directory (it has no {})", path.string(), identity_file));
  }
  try {
    const auto identity = nlohmann::json::parse(read_file(identity_path));
    run.run_id_ = identity.at("run_id").get<std::string>();
    run.case_name_ = identity.at("case").get<std::string>();
    run.overrides_ = identity.at("overrides").get<std::vector<std::string>>();
    run.checkpoint_folder_ = identity.at("checkpoints").get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", identity_path.string(), error.what()));
  }
  return run;
}

void RunDirectory::lock() {
  lock_.emplace(file(identity_file), O_RDONLY);
  if (lock_->try_lock()) return;
  throw InputError(fmt::format("{}: another process is at work on this run", path_.string()));
}

}  // namespace ligament
