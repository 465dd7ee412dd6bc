#include "io/case_values.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "core/closest_name.hpp"
#include "io/units.hpp"

namespace ligament {

namespace {

/// Reads one parameter; its errors are positioned at the value, or at the item of a list.
class ValueReader {
 public:
  ValueReader(const Parameter& parameter, CaseErrors& errors) : parameter_(parameter), errors_(errors) {}

  [[nodiscard]] std::optional<ParameterValue> read(const CaseNode& node) const {
    switch (parameter_.kind) {
      case ParameterKind::quantity:
        return widened(quantity(node, label_of_key()));
      case ParameterKind::number:
        return widened(number(node, label_of_key()));
      case ParameterKind::integer:
        return widened(integer(node, label_of_key()));
      case ParameterKind::boolean:
        return widened(typed<bool>(node, label_of_key(), "a boolean (true or false)"));
      case ParameterKind::text:
        return widened(text(node, label_of_key()));
      case ParameterKind::quantities:
      case ParameterKind::point:
        return widened(items<double>(node, fmt::format("quantities in {}", parameter_.unit), &ValueReader::quantity));
      case ParameterKind::numbers:
        return widened(items<double>(node, "numbers", &ValueReader::number));
      case ParameterKind::integers:
        return widened(items<std::int64_t>(node, "integers", &ValueReader::integer));
      case ParameterKind::texts:
        return widened(items<std::string>(node, "strings", &ValueReader::text));
      case ParameterKind::table:
        break;
    }
    return std::nullopt;
  }

 private:
  template <class T>
  static std::optional<ParameterValue> widened(std::optional<T>&& value) {
    if (!value) return std::nullopt;
    return ParameterValue(*std::move(value));
  }

  [[nodiscard]] std::string label_of_key() const { return fmt::format("'{}'", parameter_.name); }

  void complain(const CaseNode& node, std::string message) const { errors_.add(node.position, std::move(message)); }

  /// The value if nothing is wrong with it.
  template <class T>
  std::optional<T> accepted(const CaseNode& node, const std::string& label, const std::string& as_written,
                            T value) const {
    const auto complaint = [&] {
      if constexpr (std::is_same_v<T, std::string>) {
        return parameter_.complaint(value);
      } else {
        return parameter_.complaint(static_cast<double>(value));
      }
    }();
    if (!complaint) return value;
    complain(node, fmt::format("{} is {}, but {}", label, as_written, *complaint));
    return std::nullopt;
  }

  template <class T>
  std::optional<T> typed(const CaseNode& node, const std::string& label, const std::string& what) const {
    if (const T* value = std::get_if<T>(&node.value)) return *value;
    complain(node, fmt::format("{} must be {}, not {}", label, what, node.kind_text()));
    return std::nullopt;
  }

  std::optional<double> quantity(const CaseNode& node, const std::string& label) const {
    const bool is_bare = std::holds_alternative<double>(node.value) || std::holds_alternative<std::int64_t>(node.value);
    if (is_bare) {
      complain(node, fmt::format("{} is a bare number: expected {}", label, expected_quantity(parameter_.unit)));
      return std::nullopt;
    }
    const auto written = typed<std::string>(node, label, expected_quantity(parameter_.unit));
    if (!written) return std::nullopt;
    try {
      return accepted(node, label, *written, to_si(*written, parameter_.unit));
    } catch (const UnitError& error) {
      complain(node, fmt::format("{}: {}", label, error.what()));
      return std::nullopt;
    }
  }

  std::optional<double> number(const CaseNode& node, const std::string& label) const {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
      return accepted(node, label, std::to_string(*whole), static_cast<double>(*whole));
    }
    const auto value = typed<double>(node, label, "a number without unit");
    if (!value) return std::nullopt;
    return accepted(node, label, shortest(*value), *value);
  }

  std::optional<std::int64_t> integer(const CaseNode& node, const std::string& label) const {
    if (std::holds_alternative<double>(node.value)) {
      complain(node, fmt::format("{} must be an integer, not a number with a point or an exponent", label));
      return std::nullopt;
    }
    const auto value = typed<std::int64_t>(node, label, "an integer");
    if (!value) return std::nullopt;
    return accepted(node, label, std::to_string(*value), *value);
  }

  std::optional<std::string> text(const CaseNode& node, const std::string& label) const {
    const auto value = typed<std::string>(node, label, "a string");
    if (!value) return std::nullopt;
    return accepted(node, label, fmt::format("'{}'", *value), *value);
  }

  template <class T>
  std::optional<std::vector<T>> items(const CaseNode& node, const std::string& what,
                                      std::optional<T> (ValueReader::*read_item)(const CaseNode&, const std::string&)
                                          const) const {
    const auto list = typed<CaseNode::List>(node, label_of_key(), fmt::format("a list of {}", what));
    if (!list) return std::nullopt;
    if (const auto complaint = parameter_.complaint_about_length(list->size())) {
      complain(node, fmt::format("{} has {} item{}, but {}", label_of_key(), list->size(), list->size() == 1 ? "" : "s",
                                 *complaint));
      return std::nullopt;
    }
    std::vector<T> values;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const auto value = (this->*read_item)((*list)[i], fmt::format("item {} of {}", i + 1, label_of_key()));
      if (value) values.push_back(*value);
    }
    if (values.size() != list->size()) return std::nullopt;
    return values;
  }

  const Parameter& parameter_;
  CaseErrors& errors_;
};

void read_inner_table(const CaseNode& node, Parameter& parameter, const std::string& where, CaseErrors& errors) {
  if (!node.is_table()) {
    errors.add(node.position,
               fmt::format("'{}' must be a table, such as {} = {{ {} = ... }}, not {}", parameter.name, parameter.name,
                           parameter.fields.front().list().front().name, node.kind_text()));
    return;
  }
  const std::string inner = fmt::format("in '{}' {}", parameter.name, where);
  report_unknown_keys(node, parameter.fields.front().names(), inner, errors);
  read_entries(node, parameter.fields.front(), inner, node.position, errors);
}

void read_entry(const CaseNode& node, Parameter& parameter, const std::string& where, CaseErrors& errors) {
  if (parameter.kind == ParameterKind::table) {
    read_inner_table(node, parameter, where, errors);
  } else if (const auto value = ValueReader(parameter, errors).read(node)) {
    parameter.assign(*value);
  }
}

}  // namespace

void read_entries(const CaseNode& table, Parameters& parameters, const std::string& where,
                  const SourcePosition& position, CaseErrors& errors) {
  for (Parameter& parameter : parameters.list()) {
    const CaseEntry* entry = table.find(parameter.name);
    parameter.given = entry != nullptr;
    if (parameter.presence != nullptr) *parameter.presence = parameter.given;
    if (entry != nullptr) {
      read_entry(entry->node, parameter, where, errors);
    } else if (parameter.required) {
      errors.add(position, missing_key(parameter.name, where));
    }
  }
}

void report_unknown_keys(const CaseNode& table, const std::vector<std::string>& known, const std::string& where,
                         CaseErrors& errors) {
  for (const CaseEntry& entry : std::get<CaseNode::Table>(table.value)) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    errors.add(entry.key_position,
               fmt::format("unknown key '{}' {}{}", entry.key, where, did_you_mean(entry.key, known)));
  }
}

std::string missing_key(const std::string& key, const std::string& where) {
  return fmt::format("missing key '{}' {}", key, where);
}

}  // namespace ligament
