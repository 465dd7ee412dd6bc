#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/fields_vtkhdf.hpp"

namespace ligament {

/// The field files of one group in a folder, `particles_000120.hdf` and so on, and `particles.hdf.series`, the list of
/// their times that ParaView opens as an animation. The field files are the truth: the list is a function of them, so
/// that of a resumed run has the same bytes as that of an undisturbed one.
class FieldSeries {
 public:
  /// A new list; nothing is read or written.
  FieldSeries(std::filesystem::path folder, std::string group_name);

  /// Where the group of this step is written.
  [[nodiscard]] std::filesystem::path file_of(std::int64_t step) const;
  /// Enters the file of this step, which is already written, and rewrites the list. Steps must increase.
  void add(std::int64_t step, double time_s);
  /// Goes on after a checkpoint of `last_step`: deletes the field files of later steps and unfinished ones, and
  /// rebuilds the list from those that stay. -1 starts anew. FileError if a file cannot be read or deleted.
  void resume(std::int64_t last_step);

 private:
  void write_list() const;

  std::filesystem::path folder_;
  std::string group_name_;
  std::vector<FieldStamp> stamps_;  ///< by increasing step
};

}  // namespace ligament
