#include "io/csv_table.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace ligament {
namespace {

void check_word(std::string_view word) {
  if (word.find_first_of(",\"\r\n") != std::string_view::npos) {
    throw InputError(
        fmt::format("'{}' may not hold a comma, quote or line break: it names a column or cell of a table", word));
  }
}

std::string header_line(std::span<const std::string> columns) {
  std::string line = "step";
  for (const std::string& column : columns) {
    check_word(column);
    line += ',';
    line += column;
  }
  return line + '\n';
}

std::vector<std::string> split_cells(std::string_view line) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stopped_at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped_at != end) return std::nullopt;
  return value;
}

/// Bytes from the start of `content` up to the end of the last row whose step is at most `last_step`.
std::size_t kept_bytes(std::string_view content, std::size_t header_size, std::size_t n_columns, std::int64_t last_step,
                       const std::filesystem::path& path) {
  std::int64_t previous_step = 0;
  std::size_t begin = header_size;
  for (std::size_t line_number = 2;; ++line_number) {
    const std::size_t end = content.find('\n', begin);
    if (end == std::string_view::npos) return begin;
    const std::string_view line = content.substr(begin, end - begin);
    const auto step = parse_number<std::int64_t>(line.substr(0, line.find(',')));
    const auto n_commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (!step || n_commas != n_columns || *step < previous_step) {
      throw FileError(fmt::format("{}:{}: not a row of {} cells that begins with a step of at least {}", path.string(),
                                  line_number, n_columns + 1, previous_step));
    }
    if (*step > last_step) return begin;
    previous_step = *step;
    begin = end + 1;
  }
}

}  // namespace

CsvTable CsvTable::create(const std::filesystem::path& path, std::span<const std::string> columns) {
  const std::string header = header_line(columns);
  CsvTable table(FileDescriptor(path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND), columns.size(), 0);
  table.waiting_ = header;
  table.flush();
  return table;
}

CsvTable CsvTable::resume(const std::filesystem::path& path, std::span<const std::string> columns,
                          std::int64_t last_step) {
  const std::string header = header_line(columns);
  FileDescriptor file(path, O_RDWR | O_APPEND);
  const std::string content = file.read_all();
  if (!content.starts_with(header)) {
    throw FileError(fmt::format("{}: the header is '{}', expected '{}'", path.string(),
                                content.substr(0, content.find('\n')), header.substr(0, header.size() - 1)));
  }
  const std::size_t n_kept = kept_bytes(content, header.size(), columns.size(), last_step, path);
  if (n_kept != content.size() && !file.truncate(n_kept)) throw_file_error("truncate", path);
  return {std::move(file), columns.size(), n_kept};
}

void CsvTable::append(std::int64_t step, std::span<const double> values) {
  expect_columns(values.size());
  fmt::format_to(std::back_inserter(waiting_), "{}{}{}\n", step, values.empty() ? "" : ",", fmt::join(values, ","));
}

void CsvTable::append(std::int64_t step, std::span<const CsvCell> cells) {
  expect_columns(cells.size());
  std::string line = fmt::format("{}", step);
  for (const CsvCell& cell : cells) {
    if (const auto* word = std::get_if<std::string_view>(&cell)) check_word(*word);
    std::visit([&line](const auto& value) { fmt::format_to(std::back_inserter(line), ",{}", value); }, cell);
  }
  waiting_ += line + '\n';
}

void CsvTable::flush() {
  if (!file_.is_in_place()) {
    throw FileError(fmt::format("cannot write {}: it was removed or replaced under the run", file_.path().string()));
  }
  if (is_torn_ && !file_.truncate(n_bytes_)) throw_file_error("write", file_.path());
  is_torn_ = false;
  try {
    file_.write_all(waiting_);
  } catch (const FileError&) {
    // A full disk may have taken half a row. Where that cannot be cut off now it is before the next write, or by
    // resume().
    is_torn_ = !file_.truncate(n_bytes_);
    throw;
  }
  n_bytes_ += waiting_.size();
  waiting_.clear();
}

void CsvTable::sync() {
  flush();
  file_.flush_to_disk();
}

void CsvTable::expect_columns(std::size_t n_values) const {
  if (n_values != n_columns_) {
    throw std::logic_error(
        fmt::format("{}: a row of {} values for {} columns", file_.path().string(), n_values, n_columns_));
  }
}

std::size_t CsvContent::column_index(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw InputError(fmt::format("unknown column '{}'; known are {}", name, fmt::join(columns, ", ")));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::vector<double> CsvContent::numbers(std::string_view name) const {
  const std::size_t column = column_index(name);
  std::vector<double> values;
  values.reserve(rows.size());
  for (const auto& row : rows) {
    const auto value = parse_number<double>(row[column]);
    if (!value) throw FileError(fmt::format("column '{}' at step {}: '{}' is not a number", name, row[0], row[column]));
    values.push_back(*value);
  }
  return values;
}

CsvContent read_csv(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  CsvContent table;
  std::string_view rest = content;
  for (std::size_t line_number = 1;; ++line_number) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) break;
    std::vector<std::string> cells = split_cells(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (line_number == 1) {
      table.columns = std::move(cells);
    } else if (cells.size() == table.columns.size()) {
      table.rows.push_back(std::move(cells));
    } else {
      throw FileError(fmt::format("{}:{}: {} cells under a header of {}", path.string(), line_number, cells.size(),
                                  table.columns.size()));
    }
  }
  if (table.columns.empty()) throw FileError(fmt::format("{}: no header line", path.string()));
  return table;
}

}  // namespace ligament
