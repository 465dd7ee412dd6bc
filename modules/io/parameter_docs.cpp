#include "io/parameter_docs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/closest_name.hpp"
#include "core/error.hpp"
#include "io/parameter_phrases.hpp"
#include "io/units.hpp"

namespace ligament {

namespace {

/// One documented key.
struct KeyEntry {
  const TableDescription* table;
  const Variant* variant;  ///< null for what every variant has
  std::string key;         ///< "radius", "at.x"
  Parameter parameter;

  [[nodiscard]] std::string full_key() const {
    return table->path.empty() ? key : fmt::format("{}.{}", table_name(*table), key);
  }
};

std::vector<KeyEntry> all_keys(const std::vector<TableDescription>& tables) {
  std::vector<KeyEntry> keys;
  for (const TableDescription& table : tables) {
    const Parameters common = common_parameters(table);
    for (const auto& [key, parameter] : flattened(common)) keys.push_back({&table, nullptr, key, *parameter});
    for (const Variant& variant : table.variants) {
      for (const auto& [key, parameter] : flattened(variant.parameters)) {
        keys.push_back({&table, &variant, key, *parameter});
      }
    }
  }
  return keys;
}

std::string headline(const KeyEntry& entry) {
  const Parameter& parameter = entry.parameter;
  std::string text = fmt::format("{}: {}", entry.full_key(), kind_phrase(parameter));
  if (const std::string range = range_phrase(parameter); !range.empty()) text += ", " + range;
  if (const std::string value = default_phrase(parameter); !value.empty()) {
    text += ", default " + value;
  } else {
    text += parameter.required ? ", required" : ", optional";
  }
  return text;
}

std::string explained(const KeyEntry& entry) {
  std::string text = headline(entry) + "\n";
  if (!entry.parameter.description.empty()) text += fmt::format("  {}\n", entry.parameter.description);
  if (!entry.parameter.unit.empty()) text += fmt::format("  Such as \"{}\".\n", example_quantity(entry.parameter.unit));
  if (entry.variant != nullptr)
    text += fmt::format("  With {} = \"{}\".\n", entry.table->selector, entry.variant->name);
  return text;
}

std::string explained(const TableDescription& table, const std::vector<KeyEntry>& keys) {
  std::string text = fmt::format("{}: {}\n", table_phrase(table), table.description);
  for (const Variant& variant : table.variants) {
    text += fmt::format("  {} = \"{}\": {}\n", table.selector, variant.name, variant.description);
  }
  for (const KeyEntry& entry : keys) {
    if (entry.table == &table) text.append("\n").append(explained(entry));
  }
  return text;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// "zone.middle.radius" as "zone.radius": the name of an element says nothing about its keys.
std::string without_element_name(const std::vector<TableDescription>& tables, const std::string& key) {
  const std::size_t first = key.find('.');
  const std::size_t second = first == std::string::npos ? first : key.find('.', first + 1);
  if (second == std::string::npos) return key;
  const bool has_elements = std::any_of(tables.begin(), tables.end(), [&](const TableDescription& table) {
    return table.kind != TableDescription::Kind::single && table_name(table) == key.substr(0, first);
  });
  return has_elements ? key.substr(0, first) + key.substr(second) : key;
}

std::string matches(const std::vector<KeyEntry>& keys, const std::string& wanted, bool by_last_part) {
  std::string text;
  for (const KeyEntry& entry : keys) {
    const std::string name = by_last_part ? last_part(entry.key) : entry.full_key();
    if (name == wanted) text.append(text.empty() ? "" : "\n").append(explained(entry));
  }
  return text;
}

[[noreturn]] void throw_unknown(const std::vector<TableDescription>& tables, const std::vector<KeyEntry>& keys,
                                const std::string& wanted) {
  std::vector<std::string> known;
  for (const TableDescription& table : tables) known.push_back(table_name(table));
  for (const KeyEntry& entry : keys) {
    known.push_back(entry.full_key());
    if (wanted.find('.') == std::string::npos) known.push_back(last_part(entry.key));
  }
  throw InputError(fmt::format("no case file has a key '{}'{}", wanted, did_you_mean(wanted, known)));
}

}  // namespace

std::string explain(const std::vector<TableDescription>& tables, std::string_view key) {
  const std::vector<KeyEntry> keys = all_keys(tables);
  const std::string wanted(key);
  for (const TableDescription& table : tables) {
    if (!wanted.empty() && (wanted == table_name(table) || wanted == table.path)) return explained(table, keys);
  }
  const std::string candidates[] = {wanted, without_element_name(tables, wanted)};
  for (const std::string& candidate : candidates) {
    for (const bool by_last_part : {false, true}) {
      if (std::string text = matches(keys, candidate, by_last_part); !text.empty()) return text;
    }
  }
  throw_unknown(tables, keys, wanted);
}

}  // namespace ligament
