// The JSON Schema of case files.
#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "io/case_resolved.hpp"
#include "io/parameter_docs.hpp"
#include "io/parameter_phrases.hpp"
#include "io/units.hpp"

namespace ligament {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* quantity_pattern =
    "^-?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)? [A-Za-zµμ][A-Za-zµμ0-9*/^-]*$";
constexpr const char* name_pattern = "^[A-Za-z0-9_-]+$";

Json object_schema(const Parameters& parameters);

Json item_schema(const Parameter& parameter, const char* type) {
  Json schema{{"type", type}};
  if (!parameter.unit.empty()) {
    schema["pattern"] = quantity_pattern;
    schema["examples"] = Json::array({example_quantity(parameter.unit)});
    return schema;
  }
  const Range& range = parameter.range;
  if (range.at_least) schema["minimum"] = *range.at_least;
  if (range.greater_than) schema["exclusiveMinimum"] = *range.greater_than;
  if (range.at_most) schema["maximum"] = *range.at_most;
  if (range.less_than) schema["exclusiveMaximum"] = *range.less_than;
  if (!parameter.choices.empty()) schema["enum"] = parameter.choices;
  return schema;
}

Json list_schema(const Parameter& parameter, const char* type) {
  Json schema{{"type", "array"}, {"items", item_schema(parameter, type)}};
  if (parameter.min_items > 0) schema["minItems"] = parameter.min_items;
  if (parameter.max_items != std::numeric_limits<std::size_t>::max()) schema["maxItems"] = parameter.max_items;
  return schema;
}

Json value_schema(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::quantity:
    case ParameterKind::text:
      return item_schema(parameter, "string");
    case ParameterKind::quantities:
    case ParameterKind::point:
    case ParameterKind::texts:
      return list_schema(parameter, "string");
    case ParameterKind::number:
      return item_schema(parameter, "number");
    case ParameterKind::numbers:
      return list_schema(parameter, "number");
    case ParameterKind::integer:
      return item_schema(parameter, "integer");
    case ParameterKind::integers:
      return list_schema(parameter, "integer");
    case ParameterKind::boolean:
      return item_schema(parameter, "boolean");
    case ParameterKind::table:
      return object_schema(parameter.fields.front());
  }
  return {};
}

/// Range and default of quantities are in no other keyword, so the description tells them.
std::string described(const Parameter& parameter) {
  std::string text = parameter.description;
  const std::string range = range_phrase(parameter);
  if (!parameter.unit.empty() && !range.empty()) text += fmt::format(" ({})", range);
  return text;
}

/// A value as a case file would have it: quantities with their units.
Json default_json(const Parameter& parameter) {
  return std::visit(
      [&](const auto& value) -> Json {
        using Type = std::decay_t<decltype(value)>;
        if (parameter.unit.empty()) return value;
        if constexpr (std::is_same_v<Type, double>) {
          return si_text(value, parameter.unit);
        } else if constexpr (std::is_same_v<Type, std::vector<double>>) {
          Json items = Json::array();
          for (const double item : value) items.push_back(si_text(item, parameter.unit));
          return items;
        } else {
          return value;
        }
      },
      *parameter.default_value);
}

Json properties_of(const Parameters& parameters) {
  Json properties = Json::object();
  for (const Parameter& parameter : parameters.list()) {
    Json schema = value_schema(parameter);
    schema["description"] = described(parameter);
    if (!default_phrase(parameter).empty()) schema["default"] = default_json(parameter);
    properties[parameter.name] = std::move(schema);
  }
  return properties;
}

Json required_of(const Parameters& parameters) {
  Json required = Json::array();
  for (const Parameter& parameter : parameters.list()) {
    if (parameter.required) required.push_back(parameter.name);
  }
  return required;
}

Json object_schema(const Parameters& parameters) {
  Json schema{{"type", "object"}, {"properties", properties_of(parameters)}};
  if (Json required = required_of(parameters); !required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema;
}

Json variant_schema(const TableDescription& table, const Variant& variant) {
  Json condition{{"properties", {{table.selector, {{"const", variant.name}}}}}};
  // Without this the condition also holds where the selector is left out, as the default variant's must.
  if (table.default_variant != variant.name) condition["required"] = Json::array({table.selector});
  Json consequence{{"description", variant.description}, {"properties", properties_of(variant.parameters)}};
  if (Json required = required_of(variant.parameters); !required.empty()) consequence["required"] = std::move(required);
  return {{"if", std::move(condition)}, {"then", std::move(consequence)}};
}

Json element_schema(const TableDescription& table) {
  Json schema = object_schema(common_parameters(table));
  if (table.kind == TableDescription::Kind::array) schema["properties"]["name"]["pattern"] = name_pattern;
  if (table.variants.empty()) return schema;
  // Which keys are additional depends on the variant: only "unevaluated" looks into the branches.
  schema.erase("additionalProperties");
  schema["allOf"] = Json::array();
  for (const Variant& variant : table.variants) schema["allOf"].push_back(variant_schema(table, variant));
  schema["unevaluatedProperties"] = false;
  return schema;
}

Json table_schema(const TableDescription& table) {
  Json schema;
  switch (table.kind) {
    case TableDescription::Kind::single:
      schema = element_schema(table);
      break;
    case TableDescription::Kind::named:
      schema = {{"type", "object"}};
      schema["propertyNames"] = {{"pattern", name_pattern}};
      schema["additionalProperties"] = element_schema(table);
      break;
    case TableDescription::Kind::array:
      schema = {{"type", "array"}, {"items", element_schema(table)}};
      break;
  }
  schema["description"] = table.description;
  return schema;
}

}  // namespace

std::string json_schema(const std::vector<TableDescription>& tables) {
  Json schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"$comment",
       "Generated from the declarations in the program: change those, not this file, and renew it with 'ligament "
       "schema > config/case.schema.json'."},
      {"title", "ligament case file"},
      {"type", "object"},
      {"properties", Json::object()},
      {"required", Json::array()},
      {"additionalProperties", false}};
  for (const TableDescription& table : tables) {
    if (table.path.empty()) {
      schema["properties"].update(properties_of(table.parameters));
      for (Json& key : required_of(table.parameters)) schema["required"].push_back(key);
      continue;
    }
    schema["properties"][table_name(table)] = table_schema(table);
    if (table.required) schema["required"].push_back(table_name(table));
  }
  return schema.dump(2) + "\n";
}

}  // namespace ligament
