#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ligament {

/// A parameter's value between the case file and the member it is bound to. Quantities are in their SI unit; a point
/// is a list of two.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                                    std::vector<std::int64_t>, std::vector<std::string>>;

/// What a user writes for a parameter.
enum class ParameterKind {
  quantity,
  quantities,
  point,
  number,
  numbers,
  integer,
  integers,
  boolean,
  text,
  texts,
  table,
};

/// Bounds on a value, or on every item of a list, in the parameter's SI unit.
struct Range {
  std::optional<double> at_least;
  std::optional<double> greater_than;
  std::optional<double> at_most;
  std::optional<double> less_than;

  [[nodiscard]] bool contains(double value) const;
  /// "greater than 0 m and at most 1 m"; empty if there is no bound.
  [[nodiscard]] std::string text(std::string_view unit) const;
};

class Parameters;

/// One declared parameter: what it means, what it may be, and where its value goes.
struct Parameter {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  /// SI unit of quantities; empty for what has no dimension.
  std::string unit;
  std::string description;
  bool required = false;
  Range range;
  /// The allowed texts; empty if any will do.
  std::vector<std::string> choices;
  /// Least and greatest number of items of a list.
  std::size_t min_items = 0;
  std::size_t max_items = static_cast<std::size_t>(-1);
  /// The member's value when it was declared; nothing if required, or if the member was an empty optional.
  std::optional<ParameterValue> default_value;
  /// Whether the table that was read last holds the parameter.
  bool given = false;

  /// Writes the member. The value must hold the alternative of the kind, else std::bad_variant_access.
  std::function<void(const ParameterValue&)> assign;
  /// Reads the member; nothing if it is an empty optional.
  std::function<std::optional<ParameterValue>()> current;

  /// Kind table: its parameters (one entry); empty otherwise.
  std::vector<Parameters> fields;
  /// Kind table: set to whether the table was given, unless null.
  bool* presence = nullptr;

  /// What is wrong with a value, to be read after "'name' is ..., but": "must be at least 0 m".
  [[nodiscard]] std::optional<std::string> complaint(double value) const;
  [[nodiscard]] std::optional<std::string> complaint(const std::string& value) const;
  [[nodiscard]] std::optional<std::string> complaint_about_length(std::size_t n_items) const;
  /// Lists of a demanded length, in words: "2 items", "at least 1 item"; empty if any length will do.
  [[nodiscard]] std::string length_text() const;
};

/// Adds conditions to the parameter just declared.
class ParameterHandle {
 public:
  explicit ParameterHandle(Parameter& parameter) : parameter_(&parameter) {}

  /// The case must give it: the value at declaration is no default.
  ParameterHandle required();
  /// Bounds in the SI unit; of a list, on every item.
  ParameterHandle at_least(double bound);
  ParameterHandle greater_than(double bound);
  ParameterHandle at_most(double bound);
  ParameterHandle less_than(double bound);
  /// Of a list: its length.
  ParameterHandle length(std::size_t n_items);
  ParameterHandle length_at_least(std::size_t n_items);
  /// Of a text, or of every text of a list: the allowed ones.
  ParameterHandle one_of(std::vector<std::string> choices);

 private:
  Parameter* parameter_;
};

/// The parameters of one table of a case file, each bound to a member of the object that declares it.
///
/// The member's value at declaration is the default, unless the parameter is required; an empty optional means "not
/// given". Members must outlive the reading of the case, not the use of descriptions and defaults.
class Parameters {
 public:
  /// A number with its unit, "21.9 GPa", stored in the SI unit `unit`.
  ParameterHandle quantity(std::string name, double& member, std::string unit, std::string description);
  ParameterHandle quantity(std::string name, std::optional<double>& member, std::string unit, std::string description);
  /// A list of numbers with units.
  ParameterHandle quantities(std::string name, std::vector<double>& member, std::string unit, std::string description);
  /// Two numbers with units: ["1.6 m", "0 m"].
  ParameterHandle point(std::string name, std::array<double, 2>& member, std::string unit, std::string description);
  ParameterHandle point(std::string name, std::optional<std::array<double, 2>>& member, std::string unit,
                        std::string description);
  /// A number without dimension.
  ParameterHandle number(std::string name, double& member, std::string description);
  ParameterHandle number(std::string name, std::optional<double>& member, std::string description);
  ParameterHandle numbers(std::string name, std::vector<double>& member, std::string description);
  ParameterHandle integer(std::string name, std::int64_t& member, std::string description);
  ParameterHandle integer(std::string name, std::optional<std::int64_t>& member, std::string description);
  ParameterHandle integers(std::string name, std::vector<std::int64_t>& member, std::string description);
  ParameterHandle boolean(std::string name, bool& member, std::string description);
  ParameterHandle text(std::string name, std::string& member, std::string description);
  ParameterHandle text(std::string name, std::optional<std::string>& member, std::string description);
  ParameterHandle texts(std::string name, std::vector<std::string>& member, std::string description);

  /// A text that stands for a value of an enumeration.
  template <class Enum>
  ParameterHandle choice(std::string name, Enum& member,
                         std::type_identity_t<std::vector<std::pair<std::string, Enum>>> choices,
                         std::string description);
  template <class Enum>
  ParameterHandle choice(std::string name, std::optional<Enum>& member,
                         std::type_identity_t<std::vector<std::pair<std::string, Enum>>> choices,
                         std::string description);

  /// A table inside the table: at = { x = "0 m" }. The caller fills the list returned, which stays valid while more is
  /// declared. Unless require_table() names it, the table may be left out; its required parameters are then not asked
  /// for, and `present`, where given, tells.
  Parameters& table(std::string name, std::string description);
  Parameters& table(std::string name, bool& present, std::string description);
  /// The case must give the inner table called `name`. Throws std::logic_error if it is not declared.
  void require_table(std::string_view name);

  [[nodiscard]] const std::deque<Parameter>& list() const { return list_; }
  [[nodiscard]] std::deque<Parameter>& list() { return list_; }
  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::vector<std::string> names() const;
  /// Null if there is none of that name.
  [[nodiscard]] const Parameter* find(std::string_view name) const;
  /// Whether the table that was read last holds the parameter. Throws std::logic_error if it is not declared.
  [[nodiscard]] bool given(std::string_view name) const;

 private:
  Parameter& add(Parameter parameter);

  // Not a vector: handles and the lists of inner tables stay valid while more is declared.
  std::deque<Parameter> list_;
};

template <class Enum>
ParameterHandle Parameters::choice(std::string name, Enum& member,
                                   std::type_identity_t<std::vector<std::pair<std::string, Enum>>> choices,
                                   std::string description) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.kind = ParameterKind::text;
  parameter.description = std::move(description);
  for (const auto& [text, value] : choices) parameter.choices.push_back(text);
  parameter.assign = [&member, choices](const ParameterValue& value) {
    const auto& text = std::get<std::string>(value);
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.first == text; });
    if (found != choices.end()) member = found->second;
  };
  parameter.current = [&member, choices]() -> std::optional<ParameterValue> {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.second == member; });
    if (found == choices.end()) return std::nullopt;
    return found->first;
  };
  return ParameterHandle(add(std::move(parameter)));
}

template <class Enum>
ParameterHandle Parameters::choice(std::string name, std::optional<Enum>& member,
                                   std::type_identity_t<std::vector<std::pair<std::string, Enum>>> choices,
                                   std::string description) {
  // An empty optional equals no choice, so it reads back as "not given".
  std::vector<std::pair<std::string, std::optional<Enum>>> optional_choices(choices.begin(), choices.end());
  return choice<std::optional<Enum>>(std::move(name), member, std::move(optional_choices), std::move(description));
}

}  // namespace ligament
