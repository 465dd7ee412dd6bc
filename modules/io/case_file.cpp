#include "io/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/closest_name.hpp"
#include "core/error.hpp"
#include "io/case_overrides.hpp"
#include "io/case_toml.hpp"
#include "io/case_values.hpp"

namespace ligament {

namespace {

std::string content_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(fmt::format("{}: is a directory, not a case file", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  const int open_error = errno;
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(open_error)));
  std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw InputError(fmt::format("{}: cannot be read to its end", path.string()));
  return content;
}

void add_unless_there(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// What stands in the file under a name that should be a table, for messages.
std::string found_text(const CaseNode& node) {
  return node.is_list_of_tables() ? "an array of tables" : node.kind_text();
}

}  // namespace

CaseFile::CaseFile(std::string text, std::string file_name, CaseNode root)
    : text_(std::move(text)), file_name_(std::move(file_name)), root_(std::make_unique<CaseNode>(std::move(root))) {}

CaseFile CaseFile::load(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return parse(content_of(path), path.string(), overrides);
}

CaseFile CaseFile::parse(std::string text, std::string file_name, const std::vector<std::string>& overrides) {
  CaseNode root = parse_toml(text, file_name);
  CaseFile file(std::move(text), std::move(file_name), std::move(root));
  for (const std::string& override : overrides) apply_override(*file.root_, parse_override(override), file.errors_);
  return file;
}

CaseTable& CaseFile::record(CaseTable table) {
  for (const auto& known : tables_) {
    if (known->header == table.header && known->name == table.name && known->node == table.node) return *known;
  }
  return *tables_.emplace_back(std::make_unique<CaseTable>(std::move(table)));
}

TableView CaseFile::top_level() {
  CaseTable table;
  table.where = "at the top level";
  table.node = root_.get();
  return TableView(record(std::move(table)));
}

bool CaseFile::has(const std::string& name) {
  add_unless_there(asked_, name);
  return root_->find(name) != nullptr;
}

TableView CaseFile::table(const std::string& name) {
  CaseTable table;
  table.header = fmt::format("[{}]", name);
  table.name = name;
  table.where = fmt::format("in [{}]", name);
  if (has(name)) {
    const CaseNode& node = root_->find(name)->node;
    table.position = node.position;
    if (node.is_table()) {
      table.node = &node;
    } else {
      errors_.add(node.position, fmt::format("'{}' must be a table, [{}], not {}", name, name, found_text(node)));
    }
  }
  return TableView(record(std::move(table)));
}

CaseTable& CaseFile::named_table(const std::string& group, const CaseEntry& entry) {
  CaseTable table;
  table.header = fmt::format("[{}.{}]", group, entry.key);
  table.name = entry.key;
  table.where = fmt::format("in [{}.{}]", group, entry.key);
  table.node = &entry.node;
  table.position = entry.node.position;
  return record(std::move(table));
}

std::vector<TableView> CaseFile::named_tables(const std::string& group) {
  std::vector<TableView> views;
  if (!has(group)) return views;
  const CaseNode& node = root_->find(group)->node;
  if (!node.is_table()) {
    errors_.add(node.position,
                fmt::format("'{}' must hold named tables, [{}.<name>], not {}", group, group, found_text(node)));
    return views;
  }
  const auto& entries = std::get<CaseNode::Table>(node.value);
  std::vector<std::string> names;
  for (const CaseEntry& entry : entries) {
    if (entry.key_position.override_text.empty()) names.push_back(entry.key);
  }
  for (const CaseEntry& entry : entries) {
    if (!entry.key_position.override_text.empty()) {
      errors_.add(entry.key_position,
                  fmt::format("there is no [{}.{}] (there are: {}){}", group, entry.key,
                              names.empty() ? "none" : quoted_list(names), did_you_mean(entry.key, names)));
    } else if (!entry.node.is_table()) {
      errors_.add(entry.key_position, fmt::format("'{}' must be a named table, [{}.{}], not {}", entry.key, group,
                                                  entry.key, entry.node.kind_text()));
    } else if (!is_plain_name(entry.key)) {
      errors_.add(entry.key_position,
                  fmt::format("the name '{}' of [{}.*] may hold only letters, digits, '_' and '-'", entry.key, group));
    } else {
      views.emplace_back(named_table(group, entry));
    }
  }
  return views;
}

CaseTable& CaseFile::element(const std::string& array, const CaseNode& node) {
  CaseTable table;
  table.header = fmt::format("[[{}]]", array);
  table.where = fmt::format("in [[{}]]", array);
  table.node = &node;
  table.position = node.position;
  table.known.emplace_back("name");
  const CaseEntry* name = node.find("name");
  if (name == nullptr) {
    errors_.add(node.position, missing_key("name", table.where));
  } else if (const auto* text = std::get_if<std::string>(&name->node.value); text == nullptr) {
    errors_.add(name->node.position, fmt::format("'name' must be a string, not {}", name->node.kind_text()));
  } else if (!is_plain_name(*text)) {
    errors_.add(name->node.position, fmt::format("the name '{}' may hold only letters, digits, '_' and '-'", *text));
  } else {
    table.name = *text;
    table.where += fmt::format(" '{}'", *text);
    set_resolved(table.resolved, "name", toml_string(*text));
  }
  return record(std::move(table));
}

std::vector<TableView> CaseFile::array_of_tables(const std::string& name) {
  std::vector<TableView> views;
  if (!has(name)) return views;
  const CaseNode& node = root_->find(name)->node;
  if (!node.is_list_of_tables()) {
    const bool is_from_override = !node.position.override_text.empty();
    errors_.add(node.position, is_from_override ? fmt::format("the case has no [[{}]]", name)
                                                : fmt::format("'{}' must be an array of tables, [[{}]], not {}", name,
                                                              name, node.kind_text()));
    return views;
  }
  std::vector<std::string> names;
  for (const CaseNode& item : std::get<CaseNode::List>(node.value)) {
    views.emplace_back(element(name, item));
    const std::string& item_name = views.back().name();
    if (item_name.empty()) continue;
    if (std::find(names.begin(), names.end(), item_name) != names.end()) {
      errors_.add(position(views.back(), "name"), fmt::format("a second [[{}]] has the name '{}'", name, item_name));
    }
    names.push_back(item_name);
  }
  return views;
}

SourcePosition CaseFile::position(const TableView& view, std::string_view key) const {
  const CaseEntry* entry = view.present() ? view.table_->node->find(key) : nullptr;
  return entry != nullptr ? entry->node.position : view.table_->position;
}

}  // namespace ligament
