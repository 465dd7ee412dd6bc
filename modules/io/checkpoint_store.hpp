#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/checkpoint_file.hpp"

namespace ligament {

/// The checkpoints of one run: files step_<12 digits>.ckpt in a folder that one running program writes to.
class CheckpointStore {
 public:
  /// Called with each file that is passed over, and why.
  using OnBad = std::function<void(const std::filesystem::path&, const std::string& reason)>;

  /// Keeps the newest `keep` checkpoints of the run `run_id`. The folder is made by the first write.
  /// Throws InputError unless keep is at least 1.
  CheckpointStore(std::filesystem::path folder, std::string run_id, int keep);

  /// Writes a checkpoint of this run at header.step, then removes those of the run that are older than the newest
  /// `keep` good ones, and what interrupted writes left. Files that are damaged or of other runs stay.
  /// Returns the file. Throws FileError, and removes no checkpoint, when the new one can't be written.
  std::filesystem::path write(CheckpointHeader header, std::string_view payload);

  /// All files of the folder with the name of a checkpoint, newest first; empty if there is no folder.
  [[nodiscard]] std::vector<std::filesystem::path> list() const;

  /// The newest checkpoint of this run that can be read; files that are damaged or of other runs are passed over.
  [[nodiscard]] std::optional<Checkpoint> newest_good(const OnBad& on_bad) const;

 private:
  void remove_interrupted_writes() const;
  void remove_older_than_kept(const std::filesystem::path& written);
  /// Whether it is one of this run, read once unless it changes.
  [[nodiscard]] bool is_good(const std::filesystem::path& path);

  std::filesystem::path folder_;
  std::string run_id_;
  int keep_;
  std::map<std::filesystem::path, std::filesystem::file_time_type> good_;  ///< those read, and when they were written
};

}  // namespace ligament
