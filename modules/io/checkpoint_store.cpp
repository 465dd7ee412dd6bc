#include "io/checkpoint_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace ligament {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = "step_";
constexpr std::string_view suffix = ".ckpt";
constexpr std::string_view interrupted_suffix = ".ckpt.part";

std::string file_name(std::int64_t step) { return fmt::format("{}{:012}{}", prefix, step, suffix); }

/// The step in a name like step_000000001000.ckpt; nothing for any other name.
std::optional<std::int64_t> step_of(const fs::path& path) {
  const std::string name = path.filename().string();
  std::int64_t step = 0;
  const char* const digits = name.data() + std::min(prefix.size(), name.size());
  std::from_chars(digits, name.data() + name.size(), step);
  return name == file_name(step) ? std::optional(step) : std::nullopt;
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    return {};
  }
  std::vector<fs::path> files;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    files.push_back(entry->path());
  }
  if (error) {
    throw FileError(fmt::format("checkpoint folder '{}' can't be read: {}", folder.string(), error.message()));
  }
  return files;
}

}  // namespace

CheckpointStore::CheckpointStore(fs::path folder, std::string run_id, int keep)
    : folder_(std::move(folder)), run_id_(std::move(run_id)), keep_(keep) {
  if (keep_ < 1) {
    throw InputError(fmt::format("the number of checkpoints to keep must be at least 1, it is {}", keep_));
  }
}

fs::path CheckpointStore::write(CheckpointHeader header, std::string_view payload) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw FileError(fmt::format("checkpoint folder '{}' can't be made: {}", folder_.string(), error.message()));
  }
  header.run_id = run_id_;
  fs::path path = folder_ / file_name(header.step);
  write_checkpoint(path, header, payload);
  remove_interrupted_writes();
  remove_older_than_kept(path);
  return path;
}

std::vector<fs::path> CheckpointStore::list() const {
  auto files = files_of(folder_);
  std::erase_if(files, [](const fs::path& file) { return !step_of(file); });
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) { return step_of(a) > step_of(b); });
  return files;
}

std::optional<Checkpoint> CheckpointStore::newest_good(const OnBad& on_bad) const {
  for (const auto& path : list()) {
    try {
      Checkpoint checkpoint = read_checkpoint(path);
      if (checkpoint.header.run_id == run_id_) {
        return checkpoint;
      }
      on_bad(path,
             fmt::format("checkpoint file '{}' belongs to another run, {}", path.string(), checkpoint.header.run_id));
    } catch (const FileError& error) {
      on_bad(path, error.what());
    }
  }
  return std::nullopt;
}

void CheckpointStore::remove_interrupted_writes() const {
  for (const auto& file : files_of(folder_)) {
    const std::string name = file.filename().string();
    if (name.starts_with(prefix) && name.ends_with(interrupted_suffix)) {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
  }
}

// Newer files than the one just written are left alone: the run was taken up again from an older state, and what it
// did not reach yet is for the user to judge. A file that can't be removed costs disk space, not the run.
void CheckpointStore::remove_older_than_kept(const fs::path& written) {
  int n_good = 1;
  for (const auto& path : list()) {
    if (step_of(path) < step_of(written) && is_good(path) && ++n_good > keep_) {
      std::error_code ignored;
      fs::remove(path, ignored);
      good_.erase(path);
    }
  }
}

bool CheckpointStore::is_good(const fs::path& path) {
  std::error_code error;
  const fs::file_time_type changed = fs::last_write_time(path, error);
  if (error) return false;
  const auto known = good_.find(path);
  // Reading a large file at every write takes longer than writing it.
  if (known != good_.end() && known->second == changed) return true;
  good_.erase(path);
  try {
    if (read_checkpoint_header(path).run_id != run_id_) return false;
  } catch (const FileError&) {
    return false;
  }
  good_[path] = changed;
  return true;
}

}  // namespace ligament
