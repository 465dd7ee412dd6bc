#include "ensemble/swept_columns.hpp"

#include <algorithm>
#include <charconv>

#include "io/case_toml.hpp"
#include "io/units.hpp"

namespace ligament {
namespace {

/// What stands at "table.key", "table.name.key" or "key"; null if nothing does.
const CaseNode* node_at(const CaseNode& root, const std::string& key) {
  const CaseNode* node = &root;
  for (std::size_t begin = 0; begin <= key.size() && node != nullptr;) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    const std::string part = key.substr(begin, end - begin);
    if (node->is_list_of_tables()) {
      const auto& items = std::get<CaseNode::List>(node->value);
      const auto found = std::find_if(items.begin(), items.end(), [&](const CaseNode& item) {
        const std::string* name = item.find_text("name");
        return name != nullptr && *name == part;
      });
      node = found == items.end() ? nullptr : &*found;
    } else {
      const CaseEntry* entry = node->find(part);
      node = entry == nullptr ? nullptr : &entry->node;
    }
    begin = end + 1;
  }
  return node;
}

bool is_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// "J/m2" as names of columns have it: "J_per_m2".
std::string unit_name(const std::string& unit) {
  std::string name;
  for (const char c : unit) name += c == '/' ? "_per_" : std::string(1, c == '*' ? '_' : c);
  return name;
}

std::string cell_text(const std::string& value) {
  std::string cell;
  for (const char c : value) {
    if (c == '"' || c == '\n' || c == '\r') continue;
    cell += c == ',' ? ';' : c;
  }
  return cell;
}

SweptValue swept_value(const std::string& key, const std::string& value, const CaseNode* node) {
  if (node == nullptr) return {key, cell_text(value)};
  if (const auto* number = std::get_if<double>(&node->value)) return {key, shortest(*number)};
  const auto* text = std::get_if<std::string>(&node->value);
  const std::size_t space = text == nullptr ? std::string::npos : text->find(' ');
  if (space == std::string::npos || !is_number(text->substr(0, space))) return {key, cell_text(value)};
  return {key + "_" + unit_name(text->substr(space + 1)), text->substr(0, space)};
}

}  // namespace

std::vector<SweptValue> swept_values(const std::vector<Sweep>& sweeps, const EnsembleMember& member,
                                     const std::string& resolved_text) {
  const CaseNode root = parse_toml(resolved_text, "case");
  std::vector<SweptValue> values;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    values.push_back(swept_value(sweeps[i].key, member.values[i], node_at(root, sweeps[i].key)));
  }
  return values;
}

}  // namespace ligament
