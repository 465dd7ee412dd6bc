#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/file_descriptor.hpp"

namespace ligament {

/// A number or a word. Words and column names may not hold commas, quotes or line breaks: nothing is ever quoted.
using CsvCell = std::variant<double, std::int64_t, std::string_view>;

/// An append-only CSV file with one header line, whose first column is always `step`. Rows wait in memory for the next
/// flush(), and stay there as long as they cannot be written: the file has the same bytes whenever it could be. Call
/// sync() before a checkpoint of the same step is written, so that the rows a resumed run keeps are on the disk.
/// `columns` names the columns after `step`.
class CsvTable {
 public:
  /// Starts the file anew; InputError for an impossible column name, FileError if it cannot be written.
  [[nodiscard]] static CsvTable create(const std::filesystem::path& path, std::span<const std::string> columns);

  /// Goes on with a file after a checkpoint of `last_step`: keeps the header and the rows with step <= last_step,
  /// truncates later rows and a torn last line. FileError if the file is missing or is not a table with these columns
  /// whose steps never decrease; it is then left as it was.
  [[nodiscard]] static CsvTable resume(const std::filesystem::path& path, std::span<const std::string> columns,
                                       std::int64_t last_step);

  /// Adds one row; numbers are written with the fewest digits that read back to the same bits.
  void append(std::int64_t step, std::span<const double> values);
  void append(std::int64_t step, std::span<const CsvCell> cells);

  /// Writes the rows that wait. On FileError, also where the file was removed under the run, it ends with a whole row
  /// and all rows wait on.
  void flush();
  /// Brings all rows to the disk.
  void sync();
  /// Bytes of the rows that wait.
  [[nodiscard]] std::size_t n_waiting() const { return waiting_.size(); }

 private:
  CsvTable(FileDescriptor file, std::size_t n_columns, std::size_t n_bytes)
      : file_(std::move(file)), n_columns_(n_columns), n_bytes_(n_bytes) {}
  void expect_columns(std::size_t n_values) const;

  FileDescriptor file_;
  std::size_t n_columns_;  ///< after `step`
  std::size_t n_bytes_;    ///< written, all of whole rows
  bool is_torn_ = false;   ///< more than that may be in the file
  std::string waiting_;    ///< rows that are not in the file yet
};

/// A CSV file as read back: every cell as it stands in the file, `step` included.
struct CsvContent {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// Index of a column; InputError lists the known ones.
  [[nodiscard]] std::size_t column_index(std::string_view name) const;
  /// A column as numbers; InputError for an unknown column, FileError for a cell that is not a number.
  [[nodiscard]] std::vector<double> numbers(std::string_view name) const;
};

/// Reads a table with a header line; a torn last line is ignored. FileError if the file cannot be read or a row has not
/// as many cells as the header.
[[nodiscard]] CsvContent read_csv(const std::filesystem::path& path);

}  // namespace ligament
