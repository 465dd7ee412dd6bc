#include "io/parameter_phrases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/case_resolved.hpp"

namespace ligament {

namespace {

void append(std::string& text, const std::string& part) {
  if (part.empty()) return;
  if (!text.empty()) text += "; ";
  text += part;
}

/// A text described without a member behind it: nothing is ever read into it.
void declare_text(Parameters& parameters, const std::string& name, const std::string& description,
                  const std::vector<std::string>& choices, const std::optional<std::string>& default_value) {
  std::optional<std::string> value = default_value;
  ParameterHandle handle = parameters.text(name, value, description).one_of(choices);
  if (!default_value) handle.required();
  parameters.list().back().assign = nullptr;
  parameters.list().back().current = nullptr;
}

}  // namespace

std::string kind_phrase(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::quantity:
      return "quantity in " + parameter.unit;
    case ParameterKind::quantities:
      return "list of quantities in " + parameter.unit;
    case ParameterKind::point:
      return "point [x, y] in " + parameter.unit;
    case ParameterKind::number:
      return "number";
    case ParameterKind::numbers:
      return "list of numbers";
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::integers:
      return "list of integers";
    case ParameterKind::boolean:
      return "boolean";
    case ParameterKind::text:
      return "text";
    case ParameterKind::texts:
      return "list of texts";
    case ParameterKind::table:
      return "table";
  }
  return {};
}

std::string default_phrase(const Parameter& parameter) {
  const auto& value = parameter.default_value;
  return value && is_acceptable(parameter, *value) ? toml_text(parameter, *value) : std::string();
}

std::string range_phrase(const Parameter& parameter) {
  std::string text = parameter.range.text(parameter.unit);
  if (parameter.kind != ParameterKind::point) append(text, parameter.length_text());
  if (!parameter.choices.empty()) append(text, fmt::format("\"{}\"", fmt::join(parameter.choices, "\", \"")));
  return text;
}

std::string table_phrase(const TableDescription& table) {
  if (table.path.empty()) return "top level";
  return table.kind == TableDescription::Kind::array ? fmt::format("[[{}]]", table.path)
                                                     : fmt::format("[{}]", table.path);
}

std::string table_name(const TableDescription& table) { return table.path.substr(0, table.path.find('.')); }

std::vector<std::pair<std::string, const Parameter*>> flattened(const Parameters& parameters) {
  std::vector<std::pair<std::string, const Parameter*>> all;
  for (const Parameter& parameter : parameters.list()) {
    all.emplace_back(parameter.name, &parameter);
    if (parameter.kind != ParameterKind::table) continue;
    for (const auto& [name, inner] : flattened(parameter.fields.front())) {
      all.emplace_back(fmt::format("{}.{}", parameter.name, name), inner);
    }
  }
  return all;
}

Parameters common_parameters(const TableDescription& table) {
  Parameters all;
  if (table.kind == TableDescription::Kind::array && table.parameters.find("name") == nullptr) {
    declare_text(all, "name", "What it is called in messages, results and --set; no two may share it.", {}, {});
  }
  if (!table.selector.empty() && table.parameters.find(table.selector) == nullptr) {
    std::vector<std::string> names;
    for (const Variant& variant : table.variants) names.push_back(variant.name);
    declare_text(all, table.selector, "Decides which further keys the table has.", names, table.default_variant);
  }
  for (const Parameter& parameter : table.parameters.list()) all.list().push_back(parameter);
  return all;
}

}  // namespace ligament
