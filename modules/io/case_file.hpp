#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"
#include "io/case_errors.hpp"
#include "io/case_node.hpp"
#include "io/case_table.hpp"

namespace ligament {

/// A case file being read: its tables are asked for by name and read into declared parameters. Errors of meaning are
/// collected until throw_if_errors().
class CaseFile {
 public:
  /// `overrides` are the "key=value" of --set. Throws InputError if the file cannot be read, is empty, is not UTF-8 or
  /// not TOML, or if an override is no "key=value".
  [[nodiscard]] static CaseFile load(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
  /// The same from a text, with `file_name` standing in messages.
  [[nodiscard]] static CaseFile parse(std::string text, std::string file_name,
                                      const std::vector<std::string>& overrides = {});

  /// The file byte for byte.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// The path as the user gave it.
  [[nodiscard]] const std::string& file_name() const { return file_name_; }

  /// The keys above the first table.
  [[nodiscard]] TableView top_level();
  /// The table [name], which may be absent.
  [[nodiscard]] TableView table(const std::string& name);
  /// The tables [group.*], in the order of the file.
  [[nodiscard]] std::vector<TableView> named_tables(const std::string& group);
  /// The elements of [[name]], in the order of the file, each with a `name` of its own.
  [[nodiscard]] std::vector<TableView> array_of_tables(const std::string& name);
  /// Whether the file or an override gives anything under the name of a table or group; counts as asking for it.
  [[nodiscard]] bool has(const std::string& name);

  /// Reads the table's keys into the members the parameters are bound to. Several lists may be read from one table.
  void read(const TableView& view, Parameters& parameters);

  /// The text of a key whose value decides what else the table may hold (a law, a generator); one of `choices`, unless
  /// there are none. If it is wrong, or missing without a `fallback`, an error is added and the table's other keys are
  /// not checked.
  [[nodiscard]] std::optional<std::string> peek(const TableView& view, const std::string& key,
                                                const std::vector<std::string>& choices = {},
                                                const std::optional<std::string>& fallback = std::nullopt);
  /// Takes the table's other keys as they are: what they should be cannot be known.
  void leave_unchecked(const TableView& view) { view.table_->is_unchecked = true; }

  /// Where the table is.
  [[nodiscard]] SourcePosition position(const TableView& view) const { return view.table_->position; }
  /// Where the key's value is; where the table is if it does not have the key.
  [[nodiscard]] SourcePosition position(const TableView& view, std::string_view key) const;

  /// Adds an error of meaning found by the caller.
  void add_error(SourcePosition position, std::string message) { errors_.add(std::move(position), std::move(message)); }
  [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
  /// Throws InputError with the errors so far: for when the rest cannot be read.
  void throw_collected_errors() const;
  /// To be called when all is read: adds tables and keys that nobody asked for, throws InputError if there are errors.
  void throw_if_errors();

  /// What was read, defaults and overrides in, as a case file that reads back to the same values.
  [[nodiscard]] std::string resolved_text() const;

 private:
  CaseFile(std::string text, std::string file_name, CaseNode root);

  CaseTable& record(CaseTable table);
  CaseTable& element(const std::string& array, const CaseNode& node);
  CaseTable& named_table(const std::string& group, const CaseEntry& entry);
  void report_unread();

  std::string text_;
  std::string file_name_;
  // Tables that were handed out point into the nodes and records: both stay where they are when the file is moved.
  std::unique_ptr<CaseNode> root_;
  std::vector<std::unique_ptr<CaseTable>> tables_;
  std::vector<std::string> asked_;
  CaseErrors errors_;
};

}  // namespace ligament
