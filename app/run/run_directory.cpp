#include "run/run_directory.hpp"

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

void remove_run(const fs::path& path) {
  const RunDirectory earlier = RunDirectory::open(path);
  fs::remove_all(earlier.checkpoint_folder());
  fs::remove_all(path);
}

void make_room(const fs::path& path, bool overwrite) {
  if (!fs::exists(path)) return;
  const bool is_run = fs::is_directory(path) && fs::exists(path / identity_file);
  if (is_run && overwrite) return remove_run(path);
  if (is_run) {
    throw InputError(
        fmt::format("{}: holds a run already; 'ligament resume {}' goes on with it, --overwrite removes it",
                    path.string(), path.string()));
  }
  if (fs::is_directory(path) && fs::is_empty(path)) {
    fs::remove(path);
    return;
  }
  throw InputError(fmt::format("{}: exists and is no run directory; choose another with --output", path.string()));
}

}  // namespace

RunDirectory RunDirectory::create(const fs::path& path, const Case& input, const std::vector<std::string>& overrides,
                                  const fs::path& checkpoint_parent, bool overwrite) {
  RunDirectory run;
  try {
    run.path_ = normalized(path);
    make_room(run.path_, overwrite);
    run.run_id_ = new_run_id();
    run.case_name_ = input.file.file_name();
    run.overrides_ = overrides;
    run.checkpoint_folder_ =
        fs::absolute(checkpoint_parent) / fmt::format("{}-{}", run.path_.filename().string(), run.run_id_);

    fs::path part = run.path_;
    part += fmt::format(".{}.part", run.run_id_);
    fs::create_directories(part / "fields");
    write_atomically(part / "case.toml", input.file.text());
    write_atomically(part / "case_resolved.toml", input.file.resolved_text());
    const nlohmann::ordered_json identity{{"program", "ligament"},  {"version", program_version()},
                                          {"run_id", run.run_id_},  {"case", run.case_name_},
                                          {"overrides", overrides}, {"checkpoints", run.checkpoint_folder_.string()}};
    write_atomically(part / identity_file, identity.dump(2) + "\n");
    fs::rename(part, run.path_);
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

}  // namespace ligament
