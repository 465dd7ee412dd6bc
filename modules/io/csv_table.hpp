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

/// An append-only CSV file with one header line, whose first column is always `step`. Each row is one write of a whole
/// line, so a killed run leaves whole rows; call sync() before a checkpoint of the same step is written, so that the
/// rows a resumed run keeps are on the disk. `columns` names the columns after `step`.
class CsvTable {
 public:
  /// Starts the file anew; InputError for an impossible column name, FileError if it cannot be written.
  [[nodiscard]] static CsvTable create(const std::filesystem::path& path, std::span<const std::string> columns);

  /// Goes on with a file after a checkpoint of `last_step`: keeps the header and the rows with step <= last_step,
  /// truncates later rows and a torn last line. FileError if the file is missing or is not a table with these columns
  /// whose steps never decrease; it is then left as it was.
  [[nodiscard]] static CsvTable resume(const std::filesystem::path& path, std::span<const std::string> columns,
                                       std::int64_t last_step);

  /// Appends one row; numbers are written with the fewest digits that read back to the same bits. On FileError the file
  /// ends with the row before.
  void append(std::int64_t step, std::span<const double> values);
  void append(std::int64_t step, std::span<const CsvCell> cells);

  /// Flushes to the disk.
  void sync() { file_.flush_to_disk(); }

 private:
  CsvTable(FileDescriptor file, std::size_t n_columns, std::size_t n_bytes)
      : file_(std::move(file)), n_columns_(n_columns), n_bytes_(n_bytes) {}
  void append_line(std::string_view line);
  void expect_columns(std::size_t n_values) const;

  FileDescriptor file_;
  std::size_t n_columns_;  ///< after `step`
  std::size_t n_bytes_;    ///< up to the last whole row
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
