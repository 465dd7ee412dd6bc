#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ligament {

/// Where something was written: a line and column of the case file (from 1; line 0 is the file as a whole), or a --set
/// on the command line.
struct SourcePosition {
  std::size_t line = 0;
  std::size_t column = 0;
  /// "key=value" of the --set; empty for what the file says.
  std::string override_text;

  /// "case.toml:14:3" or "--set key=value".
  [[nodiscard]] std::string text(std::string_view file_name) const;
};

struct CaseEntry;

/// A date or a time, which no parameter takes.
struct CaseDate {};

/// A value of a case file with its position; tables keep the order of the file.
struct CaseNode {
  using List = std::vector<CaseNode>;
  using Table = std::vector<CaseEntry>;

  std::variant<bool, std::int64_t, double, std::string, CaseDate, List, Table> value;
  SourcePosition position;
  /// A table or array of tables written with [headers], not inside braces.
  bool has_header = false;

  [[nodiscard]] bool is_table() const { return std::holds_alternative<Table>(value); }
  [[nodiscard]] bool is_list() const { return std::holds_alternative<List>(value); }
  /// A list of tables, possibly empty.
  [[nodiscard]] bool is_list_of_tables() const;
  /// The table's entry of that name; null if there is none or this is no table.
  [[nodiscard]] const CaseEntry* find(std::string_view key) const;
  [[nodiscard]] CaseEntry* find(std::string_view key);
  /// The table's text called `key`; null if there is none.
  [[nodiscard]] const std::string* find_text(std::string_view key) const;
  /// "a string", "an integer", ...
  [[nodiscard]] const char* kind_text() const;
};

struct CaseEntry {
  std::string key;
  SourcePosition key_position;
  CaseNode node;
};

/// Whether the name can be part of a --set key and of a column's name: letters, digits, '_' and '-'.
[[nodiscard]] bool is_plain_name(std::string_view name);

}  // namespace ligament
