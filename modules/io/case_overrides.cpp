#include "io/case_overrides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "core/closest_name.hpp"
#include "core/error.hpp"
#include "io/case_toml.hpp"

namespace ligament {

namespace {

std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    parts.emplace_back(key.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

void set_position(CaseNode& node, const SourcePosition& position) {
  node.position = position;
  if (auto* items = std::get_if<CaseNode::List>(&node.value)) {
    for (CaseNode& item : *items) set_position(item, position);
  } else if (auto* entries = std::get_if<CaseNode::Table>(&node.value)) {
    for (CaseEntry& entry : *entries) {
      entry.key_position = position;
      set_position(entry.node, position);
    }
  }
}

CaseNode override_node(const Override& override, const SourcePosition& position) {
  CaseNode node;
  if (std::optional<CaseNode> parsed = parse_toml_value(override.value)) {
    node = *std::move(parsed);
  } else {
    node.value = override.value;
  }
  set_position(node, position);
  return node;
}

CaseEntry& added_entry(CaseNode& table, const std::string& key, const SourcePosition& position, CaseNode node) {
  auto& entries = std::get<CaseNode::Table>(table.value);
  return entries.emplace_back(CaseEntry{key, position, std::move(node)});
}

/// The element of an array of tables; null, with an error added, if it has none of that name.
CaseNode* named_element(CaseNode& array, const std::string& array_name, const std::string& name,
                        const SourcePosition& position, CaseErrors& errors) {
  std::vector<std::string> names;
  for (CaseNode& item : std::get<CaseNode::List>(array.value)) {
    const std::string* item_name = item.find_text("name");
    if (item_name == nullptr) continue;
    if (*item_name == name) return &item;
    names.push_back(*item_name);
  }
  errors.add(position, fmt::format("there is no [[{}]] named '{}' (there are: {}){}", array_name, name,
                                   names.empty() ? "none" : quoted_list(names), did_you_mean(name, names)));
  return nullptr;
}

/// The table that holds the last part of the path; null, with an error added, if there can be none.
CaseNode* holder(CaseNode& root, const std::vector<std::string>& path, const SourcePosition& position,
                 CaseErrors& errors) {
  CaseNode* node = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (node->is_table()) {
      CaseEntry* entry = node->find(path[i]);
      if (entry == nullptr) {
        CaseNode table;
        table.value = CaseNode::Table{};
        table.position = position;
        entry = &added_entry(*node, path[i], position, std::move(table));
      }
      node = &entry->node;
    } else {
      node = named_element(*node, path[i - 1], path[i], position, errors);
    }
    if (node == nullptr) return nullptr;
    if (!node->is_table() && !node->is_list_of_tables()) {
      errors.add(position,
                 fmt::format("'{}' is {}, which has no key '{}'", fmt::join(path.begin(), path.begin() + i + 1, "."),
                             node->kind_text(), path[i + 1]));
      return nullptr;
    }
  }
  return node;
}

}  // namespace

Override parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    throw InputError(fmt::format("--set '{}': expected key=value, such as generation.seed=3", text));
  }
  Override override{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
  for (const std::string& part : split_key(override.key)) {
    if (!is_plain_name(part)) {
      throw InputError(fmt::format("--set '{}': '{}' is not a key, such as generation.seed", text, override.key));
    }
  }
  return override;
}

void apply_override(CaseNode& root, const Override& override, CaseErrors& errors) {
  const SourcePosition position{.override_text = fmt::format("{}={}", override.key, override.value)};
  const std::vector<std::string> path = split_key(override.key);
  CaseNode* table = holder(root, path, position, errors);
  if (table == nullptr) return;
  CaseEntry* existing = table->find(path.back());
  if (!table->is_table() || (existing != nullptr && existing->node.has_header)) {
    errors.add(position, fmt::format("'{}' is a table: name one of its keys", override.key));
    return;
  }
  CaseNode node = override_node(override, position);
  if (existing != nullptr) {
    existing->node = std::move(node);
  } else {
    added_entry(*table, path.back(), position, std::move(node));
  }
}

}  // namespace ligament
