#include "core/parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "core/closest_name.hpp"

namespace ligament {

namespace {

/// The alternative of ParameterValue that carries a member of type T.
template <class T>
struct Carrier {
  using type = T;
};
template <>
struct Carrier<std::array<double, 2>> {
  using type = std::vector<double>;
};

template <class T>
T unpacked(const ParameterValue& value) {
  const auto& carried = std::get<typename Carrier<T>::type>(value);
  if constexpr (std::is_same_v<T, std::array<double, 2>>) {
    return {carried.at(0), carried.at(1)};
  } else {
    return carried;
  }
}

template <class T>
ParameterValue packed(const T& member) {
  if constexpr (std::is_same_v<T, std::array<double, 2>>) {
    return std::vector<double>(member.begin(), member.end());
  } else {
    return member;
  }
}

template <class T>
void bind(Parameter& parameter, T& member) {
  parameter.assign = [&member](const ParameterValue& value) { member = unpacked<T>(value); };
  parameter.current = [&member]() -> std::optional<ParameterValue> { return packed(member); };
}

template <class T>
void bind(Parameter& parameter, std::optional<T>& member) {
  parameter.assign = [&member](const ParameterValue& value) { member = unpacked<T>(value); };
  parameter.current = [&member]() -> std::optional<ParameterValue> {
    if (!member) return std::nullopt;
    return packed(*member);
  };
}

template <class Member>
Parameter bound(ParameterKind kind, std::string&& name, Member& member, std::string&& unit, std::string&& description) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.kind = kind;
  parameter.unit = std::move(unit);
  parameter.description = std::move(description);
  if (kind == ParameterKind::point) parameter.min_items = parameter.max_items = 2;
  bind(parameter, member);
  return parameter;
}

std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

std::string counted(std::size_t n) { return fmt::format("{} item{}", n, n == 1 ? "" : "s"); }

}  // namespace

bool Range::contains(double value) const {
  return (!at_least || value >= *at_least) && (!greater_than || value > *greater_than) &&
         (!at_most || value <= *at_most) && (!less_than || value < *less_than);
}

std::string Range::text(std::string_view unit) const {
  std::string all;
  const auto append = [&](const char* relation, const std::optional<double>& bound) {
    if (!bound) return;
    if (!all.empty()) all += " and ";
    all += fmt::format("{} {}", relation, with_unit(*bound, unit));
  };
  append("at least", at_least);
  append("greater than", greater_than);
  append("at most", at_most);
  append("less than", less_than);
  return all;
}

std::optional<std::string> Parameter::complaint(double value) const {
  if (!std::isfinite(value)) return "must be finite";
  if (!range.contains(value)) return fmt::format("must be {}", range.text(unit));
  return std::nullopt;
}

std::optional<std::string> Parameter::complaint(const std::string& value) const {
  const bool known = choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end();
  if (known) return std::nullopt;
  return fmt::format("must be {}{}{}", choices.size() > 1 ? "one of " : "", quoted_list(choices),
                     did_you_mean(value, choices));
}

std::optional<std::string> Parameter::complaint_about_length(std::size_t n_items) const {
  if (n_items >= min_items && n_items <= max_items) return std::nullopt;
  return fmt::format("must have {}", length_text());
}

std::string Parameter::length_text() const {
  if (min_items == max_items) return counted(min_items);
  return min_items > 0 ? fmt::format("at least {}", counted(min_items)) : std::string();
}

ParameterHandle ParameterHandle::required() {
  parameter_->required = true;
  parameter_->default_value.reset();
  return *this;
}

ParameterHandle ParameterHandle::at_least(double bound) {
  parameter_->range.at_least = bound;
  return *this;
}

ParameterHandle ParameterHandle::greater_than(double bound) {
  parameter_->range.greater_than = bound;
  return *this;
}

ParameterHandle ParameterHandle::at_most(double bound) {
  parameter_->range.at_most = bound;
  return *this;
}

ParameterHandle ParameterHandle::less_than(double bound) {
  parameter_->range.less_than = bound;
  return *this;
}

ParameterHandle ParameterHandle::length(std::size_t n_items) {
  parameter_->min_items = parameter_->max_items = n_items;
  return *this;
}

ParameterHandle ParameterHandle::length_at_least(std::size_t n_items) {
  parameter_->min_items = n_items;
  return *this;
}

ParameterHandle ParameterHandle::one_of(std::vector<std::string> choices) {
  parameter_->choices = std::move(choices);
  return *this;
}

ParameterHandle Parameters::quantity(std::string name, double& member, std::string unit, std::string description) {
  return ParameterHandle(
      add(bound(ParameterKind::quantity, std::move(name), member, std::move(unit), std::move(description))));
}

ParameterHandle Parameters::quantity(std::string name, std::optional<double>& member, std::string unit,
                                     std::string description) {
  return ParameterHandle(
      add(bound(ParameterKind::quantity, std::move(name), member, std::move(unit), std::move(description))));
}

ParameterHandle Parameters::quantities(std::string name, std::vector<double>& member, std::string unit,
                                       std::string description) {
  return ParameterHandle(
      add(bound(ParameterKind::quantities, std::move(name), member, std::move(unit), std::move(description))));
}

ParameterHandle Parameters::point(std::string name, std::array<double, 2>& member, std::string unit,
                                  std::string description) {
  return ParameterHandle(
      add(bound(ParameterKind::point, std::move(name), member, std::move(unit), std::move(description))));
}

ParameterHandle Parameters::point(std::string name, std::optional<std::array<double, 2>>& member, std::string unit,
                                  std::string description) {
  return ParameterHandle(
      add(bound(ParameterKind::point, std::move(name), member, std::move(unit), std::move(description))));
}

ParameterHandle Parameters::number(std::string name, double& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::number, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::number(std::string name, std::optional<double>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::number, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::numbers(std::string name, std::vector<double>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::numbers, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::integer(std::string name, std::int64_t& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::integer, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::integer(std::string name, std::optional<std::int64_t>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::integer, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::integers(std::string name, std::vector<std::int64_t>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::integers, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::boolean(std::string name, bool& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::boolean, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::text(std::string name, std::string& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::text, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::text(std::string name, std::optional<std::string>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::text, std::move(name), member, {}, std::move(description))));
}

ParameterHandle Parameters::texts(std::string name, std::vector<std::string>& member, std::string description) {
  return ParameterHandle(add(bound(ParameterKind::texts, std::move(name), member, {}, std::move(description))));
}

Parameters& Parameters::table(std::string name, std::string description) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.kind = ParameterKind::table;
  parameter.description = std::move(description);
  parameter.fields.emplace_back();
  return add(std::move(parameter)).fields.front();
}

Parameters& Parameters::table(std::string name, bool& present, std::string description) {
  Parameters& fields = table(std::move(name), std::move(description));
  list_.back().presence = &present;
  return fields;
}

void Parameters::require_table(std::string_view name) {
  for (Parameter& parameter : list_) {
    if (parameter.kind != ParameterKind::table || parameter.name != name) continue;
    parameter.required = true;
    return;
  }
  throw std::logic_error(fmt::format("table '{}' is not declared", name));
}

std::vector<std::string> Parameters::names() const {
  std::vector<std::string> all;
  for (const Parameter& parameter : list_) all.push_back(parameter.name);
  return all;
}

const Parameter* Parameters::find(std::string_view name) const {
  for (const Parameter& parameter : list_) {
    if (parameter.name == name) return &parameter;
  }
  return nullptr;
}

bool Parameters::given(std::string_view name) const {
  const Parameter* parameter = find(name);
  if (parameter == nullptr) throw std::logic_error(fmt::format("parameter '{}' is not declared", name));
  return parameter->given;
}

Parameter& Parameters::add(Parameter parameter) {
  if (find(parameter.name) != nullptr) {
    throw std::logic_error(fmt::format("parameter '{}' is declared twice", parameter.name));
  }
  if (parameter.current) parameter.default_value = parameter.current();
  return list_.emplace_back(std::move(parameter));
}

}  // namespace ligament
