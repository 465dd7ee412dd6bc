#pragma once

#include <filesystem>
#include <optional>

#include "ensemble/plan.hpp"
#include "io/file_descriptor.hpp"

namespace ligament {

/// The folder of an ensemble: what was asked for, and below it the run directories. Locked while the object
/// lives.
class EnsembleDirectory {
 public:
  /// Makes the folder, or goes on with the ensemble that is there. That must be one of the same case, overrides and
  /// swept keys; seeds and values may only have become more. `overwrite` removes it with all its runs first. Throws
  /// InputError, naming the difference, if it is another one, if another process is at work on it, or if something else
  /// is there; FileError if the folder cannot be made.
  EnsembleDirectory(const std::filesystem::path& path, const EnsembleRequest& request, bool overwrite);

 private:
  void lock(const std::filesystem::path& path);

  std::optional<FileDescriptor> lock_;
};

}  // namespace ligament
