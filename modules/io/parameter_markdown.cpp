// The reference of case files in Markdown.
#include <fmt/format.h>

#include "io/parameter_docs.hpp"
#include "io/parameter_phrases.hpp"

namespace ligament {

namespace {

/// A bar in a cell would end it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string default_cell(const Parameter& parameter) {
  if (parameter.required) return "**required**";
  const std::string value = default_phrase(parameter);
  return value.empty() ? std::string("—") : fmt::format("`{}`", cell(value));
}

std::string key_table(const Parameters& parameters) {
  if (parameters.empty()) return {};
  std::string text = "| key | kind | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const auto& [key, parameter] : flattened(parameters)) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key, kind_phrase(*parameter), default_cell(*parameter),
                        cell(range_phrase(*parameter)), cell(parameter->description));
  }
  return text + "\n";
}

std::string section(const TableDescription& table) {
  const std::string title = table.path.empty() ? "Top level" : fmt::format("`{}`", table_phrase(table));
  std::string text = fmt::format("## {}\n\n", title);
  if (!table.description.empty()) text += table.description + "\n\n";
  if (table.required) text += "Every case must have it.\n\n";
  text += key_table(common_parameters(table));
  for (const Variant& variant : table.variants) {
    text += fmt::format("### `{} = \"{}\"`\n\n", table.selector, variant.name);
    if (!variant.description.empty()) text += variant.description + "\n\n";
    text += variant.parameters.empty() ? "No further keys.\n\n" : key_table(variant.parameters);
  }
  return text;
}

}  // namespace

std::string markdown_reference(const std::vector<TableDescription>& tables) {
  std::string text =
      "# Case files\n\n"
      "Generated from the declarations in the program: change those, not this file, and renew it with\n"
      "`ligament reference > config/case_reference.md`.\n\n"
      "A quantity is a text with a number, one space and a unit: `\"21.9 GPa\"`, `\"7 kN/m\"`, `\"1879 kg/m3\"`. Any "
      "unit of the right dimension will do. A default of — means: not given.\n\n";
  for (const TableDescription& table : tables) text += section(table);
  text.pop_back();
  return text;
}

}  // namespace ligament
