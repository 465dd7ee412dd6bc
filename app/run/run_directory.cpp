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
/// What resumes have changed. run.json itself stays as it is: it is what processes lock.
constexpr const char* changes_file = "changes.json";

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

constexpr std::string_view part_suffix = ".part";

/// A folder that is on its way to this path, or from it.
fs::path part_of(const fs::path& path, const std::string& run_id) {
  return fs::path(path) += fmt::format(".{}{}", run_id, part_suffix);
}

/// Removes the parts of this path that killed processes have left; those that are still at work lock theirs.
void remove_left_parts(const fs::path& path, std::size_t id_length) {
  const std::string begin = path.filename().string() + ".";
  for (const auto& entry : fs::directory_iterator(path.parent_path())) {
    const std::string name = entry.path().filename().string();
    const bool is_part = name.starts_with(begin) && name.ends_with(part_suffix) &&
                         name.size() == begin.size() + id_length + part_suffix.size();
    if (is_part && FileDescriptor(entry.path(), O_RDONLY | O_DIRECTORY).try_lock()) fs::remove_all(entry.path());
  }
}

/// A folder that is removed unless it gets its final name.
class PartFolder {
 public:
  explicit PartFolder(fs::path path) : path_(std::move(path)) {
    fs::create_directories(path_);
    lock_.emplace(path_, O_RDONLY | O_DIRECTORY);
    static_cast<void>(lock_->try_lock());
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  ~PartFolder() {
    std::error_code already_failing;
    fs::remove_all(path_, already_failing);
  }
  fs::path operator/(const char* name) const { return path_ / name; }

  /// Puts it in the place of what check_room() has let pass.
  void publish(const fs::path& final_path) const {
    if (!is_run(final_path)) {
      fs::remove(final_path);
      return rename_to(final_path);
    }
    RunDirectory earlier = RunDirectory::open(final_path);
    earlier.set_aside();
    rename_to(final_path);
    earlier.remove();
  }

 private:
  void rename_to(const fs::path& final_path) const {
    fs::rename(path_, final_path);
    FileDescriptor(final_path.parent_path(), O_RDONLY | O_DIRECTORY).flush_to_disk();
  }

  fs::path path_;
  std::optional<FileDescriptor> lock_;
};

/// Writes a copy of every file that the case has read; returns where it is, by its path in the case.
nlohmann::ordered_json write_copies(const PartFolder& folder, const InputFiles& files) {
  nlohmann::ordered_json copies = nlohmann::ordered_json::object();
  for (const auto& [path, content] : files.contents()) {
    const std::string copy = fmt::format("inputs/{}{}", copies.size() + 1, fs::path(path).extension().string());
    fs::create_directories(folder / "inputs");
    write_atomically(folder / copy.c_str(), content);
    copies[path] = copy;
  }
  return copies;
}

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

    fs::create_directories(run.path_.parent_path());
    remove_left_parts(run.path_, run.run_id_.size());
    const PartFolder part(part_of(run.path_, run.run_id_));
    fs::create_directory(part / "fields");
    const nlohmann::ordered_json copies = write_copies(part, *input.files);
    write_atomically(part / "case.toml", input.file.text());
    write_atomically(part / "case_resolved.toml", input.file.resolved_text());
    const nlohmann::ordered_json identity{{"program", "ligament"},
                                          {"version", program_version()},
                                          {"run_id", run.run_id_},
                                          {"case", run.case_name_},
                                          {"overrides", overrides},
                                          {"inputs", copies},
                                          {"checkpoints", run.checkpoint_folder_.string()}};
    write_atomically(part / identity_file, identity.dump(2) + "\n");
    part.publish(run.path_);
    run.lock();
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("{}: cannot make the run directory: {}", path.string(), error.code().message()));
  } catch (const nlohmann::json::exception&) {
    throw InputError(
        fmt::format("{}: the names of case, run directory and working directory must be UTF-8 text", path.string()));
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
    const fs::path changes = run.file(changes_file);
    const auto& latest = fs::exists(changes) ? nlohmann::json::parse(read_file(changes)) : identity;
    run.overrides_ = latest.at("overrides").get<std::vector<std::string>>();
    run.checkpoint_folder_ = identity.at("checkpoints").get<std::string>();
    const auto inputs = identity.value("inputs", nlohmann::json::object());
    for (const auto& [name, copy] : inputs.items()) run.copies_[name] = run.file(copy);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", identity_path.string(), error.what()));
  }
  return run;
}

void RunDirectory::set_aside() {
  lock();
  const fs::path aside = part_of(path_, run_id_);
  fs::rename(path_, aside);
  path_ = aside;
}

void RunDirectory::remove() {
  // Whatever run.json says, only a folder that bears the run's id is the run's own.
  if (checkpoint_folder_.filename().string().ends_with("-" + run_id_)) fs::remove_all(checkpoint_folder_);
  fs::remove_all(path_);
}

void RunDirectory::change_overrides(const std::vector<std::string>& overrides, const Case& input) {
  write_atomically(file("case_resolved.toml"), input.file.resolved_text());
  write_atomically(file(changes_file), nlohmann::ordered_json{{"overrides", overrides}}.dump(2) + "\n");
  overrides_ = overrides;
}

void RunDirectory::lock() {
  lock_.emplace(file(identity_file), O_RDONLY);
  if (lock_->try_lock()) return;
  throw InputError(fmt::format("{}: another process is at work on this run", path_.string()));
}

}  // namespace ligament
