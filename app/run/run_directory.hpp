#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "case/case.hpp"
#include "io/file_descriptor.hpp"

namespace ligament {

/// The folder of a run: its case with copies of the files that it names, what identifies it, and its results.
class RunDirectory {
 public:
  /// Makes the folder with the case and run.json in it, locked; it appears under its name when it is complete.
  /// `overwrite` removes a run that is there. Throws InputError if there is one and it does not, if another process is
  /// at work on it, or if something else is there; FileError if the folder cannot be made.
  static RunDirectory create(const std::filesystem::path& path, const Case& input,
                             const std::vector<std::string>& overrides, const std::filesystem::path& checkpoint_parent,
                             bool overwrite);

  /// Opens the folder of an earlier run. Throws InputError if it is none.
  static RunDirectory open(const std::filesystem::path& path);

  /// Goes on with these overrides, also whenever the run is resumed. Throws FileError if they cannot be written down.
  void change_overrides(const std::vector<std::string>& overrides, const Case& input);

  /// Keeps other processes from working on the run while this object lives. Throws InputError if one does already.
  void lock();

  /// Locks the run and gives its folder a name that is no run's, so that another may take its place at once.
  void set_aside();
  /// Removes what was set aside, with its checkpoints.
  void remove();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::string& run_id() const { return run_id_; }
  [[nodiscard]] const std::filesystem::path& checkpoint_folder() const { return checkpoint_folder_; }
  /// The --set of the first run, and of those that resumed it.
  [[nodiscard]] const std::vector<std::string>& overrides() const { return overrides_; }
  /// The copies of files that the case names.
  [[nodiscard]] const FileCopies& copies() const { return copies_; }
  /// The case file as it was named.
  [[nodiscard]] const std::string& case_name() const { return case_name_; }

 private:
  std::filesystem::path path_;
  std::string run_id_;
  std::string case_name_;
  std::filesystem::path checkpoint_folder_;
  std::vector<std::string> overrides_;
  FileCopies copies_;
  std::optional<FileDescriptor> lock_;
};

}  // namespace ligament
