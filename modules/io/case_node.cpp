#include "io/case_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ligament {

std::string SourcePosition::text(std::string_view file_name) const {
  if (!override_text.empty()) return "--set " + override_text;
  return line == 0 ? std::string(file_name) : fmt::format("{}:{}:{}", file_name, line, column);
}

bool CaseNode::is_list_of_tables() const {
  const List* items = std::get_if<List>(&value);
  return items != nullptr && std::all_of(items->begin(), items->end(), [](const CaseNode& n) { return n.is_table(); });
}

CaseEntry* CaseNode::find(std::string_view key) {
  Table* entries = std::get_if<Table>(&value);
  if (entries == nullptr) return nullptr;
  const auto found = std::find_if(entries->begin(), entries->end(), [&](const CaseEntry& e) { return e.key == key; });
  return found == entries->end() ? nullptr : &*found;
}

const CaseEntry* CaseNode::find(std::string_view key) const { return const_cast<CaseNode*>(this)->find(key); }

const std::string* CaseNode::find_text(std::string_view key) const {
  const CaseEntry* entry = find(key);
  return entry == nullptr ? nullptr : std::get_if<std::string>(&entry->node.value);
}

const char* CaseNode::kind_text() const {
  constexpr std::array texts{"a boolean", "an integer", "a number", "a string", "a date or time", "a list", "a table"};
  return texts.at(value.index());
}

bool is_plain_name(std::string_view name) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(plain) == std::string_view::npos;
}

}  // namespace ligament
