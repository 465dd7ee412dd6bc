#include "io/case_resolved.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/units.hpp"

namespace ligament {

namespace {

std::string toml_number(double value) {
  std::string text = shortest(value);
  // Without a point or an exponent it would read back as an integer.
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

/// Writes one value, or each item of a list, of a parameter.
struct ValueWriter {
  std::string_view unit;

  [[nodiscard]] std::string operator()(bool value) const { return value ? "true" : "false"; }
  [[nodiscard]] std::string operator()(std::int64_t value) const { return std::to_string(value); }
  [[nodiscard]] std::string operator()(double value) const {
    return unit.empty() ? toml_number(value) : toml_string(si_text(value, unit));
  }
  [[nodiscard]] std::string operator()(const std::string& value) const { return toml_string(value); }
  template <class T>
  [[nodiscard]] std::string operator()(const std::vector<T>& values) const {
    std::vector<std::string> items;
    for (const T& value : values) items.push_back((*this)(value));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
};

struct ValueCheck {
  const Parameter& parameter;

  bool operator()(bool /*value*/) const { return true; }
  bool operator()(std::int64_t value) const { return !parameter.complaint(static_cast<double>(value)); }
  bool operator()(double value) const { return !parameter.complaint(value); }
  bool operator()(const std::string& value) const { return !parameter.complaint(value); }
  template <class T>
  bool operator()(const std::vector<T>& values) const {
    return !parameter.complaint_about_length(values.size()) && std::all_of(values.begin(), values.end(), *this);
  }
};

bool has_required(const Parameters& parameters) {
  return std::any_of(parameters.list().begin(), parameters.list().end(), [](const Parameter& p) { return p.required; });
}

std::optional<std::string> resolved_table(const Parameter& parameter) {
  const Parameters& fields = parameter.fields.front();
  // Writing a table that was left out would make it given.
  if (!parameter.given && (parameter.presence != nullptr || has_required(fields))) return std::nullopt;
  std::vector<std::string> entries;
  for (const Parameter& field : fields.list()) {
    if (const auto value = resolved_value(field)) entries.push_back(fmt::format("{} = {}", field.name, *value));
  }
  if (entries.empty() && !parameter.given) return std::nullopt;
  return entries.empty() ? std::string("{}") : fmt::format("{{ {} }}", fmt::join(entries, ", "));
}

}  // namespace

std::optional<std::string> resolved_value(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::table) return resolved_table(parameter);
  if (!parameter.given && parameter.required) return std::nullopt;
  const std::optional<ParameterValue> value = parameter.current();
  if (!value || !is_acceptable(parameter, *value)) return std::nullopt;
  return toml_text(parameter, *value);
}

bool is_acceptable(const Parameter& parameter, const ParameterValue& value) {
  return std::visit(ValueCheck{parameter}, value);
}

std::string toml_text(const Parameter& parameter, const ParameterValue& value) {
  return std::visit(ValueWriter{parameter.unit}, value);
}

void set_resolved(ResolvedKeys& keys, const std::string& key, std::string value) {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& pair) { return pair.first == key; });
  if (found != keys.end()) {
    found->second = std::move(value);
  } else {
    keys.emplace_back(key, std::move(value));
  }
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20 || code == 0x7F) {
      quoted += fmt::format("\\u{:04X}", code);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace ligament
