// The reading of tables: the part of CaseFile that fills parameters and reports what nobody asked for.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/closest_name.hpp"
#include "core/error.hpp"
#include "io/case_file.hpp"
#include "io/case_values.hpp"

namespace ligament {

namespace {

/// The error for an absent table: one for all the keys it must have.
void report_absent_table(const CaseTable& table, const Parameters& parameters, CaseErrors& errors) {
  // Something that is no table stands in its place: that was reported when the table was asked for.
  if (table.position.line > 0 || !table.position.override_text.empty()) return;
  std::vector<std::string> required;
  for (const Parameter& parameter : parameters.list()) {
    if (parameter.required) required.push_back(parameter.name);
  }
  if (required.empty()) return;
  errors.add(table.position, fmt::format("missing table {}, which must give {}", table.header, quoted_list(required)));
}

void keep_resolved(const Parameters& parameters, ResolvedKeys& keys) {
  for (const Parameter& parameter : parameters.list()) {
    if (auto value = resolved_value(parameter)) set_resolved(keys, parameter.name, *std::move(value));
  }
}

bool is_table_like(const CaseNode& node) { return node.is_table() || (node.is_list_of_tables() && node.has_header); }

}  // namespace

void CaseFile::read(const TableView& view, Parameters& parameters) {
  CaseTable& table = *view.table_;
  for (const std::string& name : parameters.names()) table.known.push_back(name);
  if (view.present()) {
    read_entries(*table.node, parameters, table.where, table.position, errors_);
  } else {
    const CaseNode nothing{.value = CaseNode::Table{}, .position = {}};
    CaseErrors ignored;
    read_entries(nothing, parameters, table.where, table.position, ignored);
    report_absent_table(table, parameters, errors_);
  }
  keep_resolved(parameters, table.resolved);
}

std::optional<std::string> CaseFile::peek(const TableView& view, const std::string& key,
                                          const std::vector<std::string>& choices,
                                          const std::optional<std::string>& fallback) {
  std::optional<std::string> text;
  Parameters parameters;
  ParameterHandle handle = parameters.text(key, text, {}).one_of(choices);
  if (!fallback) handle.required();
  read(view, parameters);
  if (fallback && !parameters.given(key)) {
    text = fallback;
    set_resolved(view.table_->resolved, key, toml_string(*fallback));
  }
  if (!text) leave_unchecked(view);
  return text;
}

void CaseFile::report_unread() {
  std::vector<std::string> top_level_keys;
  for (const auto& table : tables_) {
    if (table->node == root_.get()) {
      top_level_keys = table->known;
    } else if (table->node != nullptr && !table->is_unchecked) {
      report_unknown_keys(*table->node, table->known, table->where, errors_);
    }
  }
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const CaseEntry& entry : std::get<CaseNode::Table>(root_->value)) {
    if (is_in(asked_, entry.key) || is_in(top_level_keys, entry.key)) continue;
    if (is_table_like(entry.node)) {
      const std::string header =
          entry.node.is_table() ? fmt::format("[{}]", entry.key) : fmt::format("[[{}]]", entry.key);
      errors_.add(entry.node.position, fmt::format("unknown table {}{}", header, did_you_mean(entry.key, asked_)));
    } else {
      errors_.add(entry.key_position, fmt::format("unknown key '{}' at the top level{}", entry.key,
                                                  did_you_mean(entry.key, top_level_keys)));
    }
  }
}

void CaseFile::throw_collected_errors() const {
  if (has_errors()) throw InputError(errors_.text(file_name_));
}

void CaseFile::throw_if_errors() {
  report_unread();
  throw_collected_errors();
}

std::string CaseFile::resolved_text() const {
  std::vector<const CaseTable*> sorted;
  for (const auto& table : tables_) sorted.push_back(table.get());
  // What the file has, in its order; then what only an override or a default gives.
  const auto rank = [](const CaseTable* table) {
    if (table->header.empty()) return std::size_t{0};
    return table->position.line > 0 ? table->position.line : std::numeric_limits<std::size_t>::max();
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](auto* a, auto* b) { return rank(a) < rank(b); });
  std::string text = "# The case as it was read: every value in SI units, defaults and overrides in.\n";
  for (const CaseTable* table : sorted) {
    if (table->resolved.empty() && table->node == nullptr) continue;
    if (!table->header.empty()) text += fmt::format("\n{}\n", table->header);
    for (const auto& [key, value] : table->resolved) text += fmt::format("{} = {}\n", key, value);
  }
  return text;
}

}  // namespace ligament
