#pragma once

#include <cstdint>
#include <deque>
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
  /// Takes the bytes of the file of this step, to be written by the next flush(). Steps must increase.
  void add(std::int64_t step, double time_s, std::string image);
  /// Writes the files that wait, in their order, and then the list. On FileError the rest waits on.
  void flush();
  /// Bytes of the files that wait.
  [[nodiscard]] std::size_t n_waiting() const;
  /// Goes on after a checkpoint of `last_step`: deletes the field files of later steps and unfinished ones, and
  /// rebuilds the list from those that stay. -1 starts anew. FileError if a file cannot be read or deleted.
  void resume(std::int64_t last_step);

 private:
  struct WaitingFile {
    FieldStamp stamp;
    std::string image;
  };
  void write_list() const;

  std::filesystem::path folder_;
  std::string group_name_;
  std::vector<FieldStamp> stamps_;   ///< of the files written, by increasing step
  bool is_listed_ = true;            ///< all of them are in the list
  std::deque<WaitingFile> waiting_;  ///< for a write, by increasing step
};

}  // namespace ligament
