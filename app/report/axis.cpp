#include "report/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ligament {

std::string Axis::values() const { return fmt::format("(column('{}')*{})", column, factor); }

UnitPrefix prefix_for(double largest) {
  for (const UnitPrefix& prefix : {UnitPrefix{1e9, "G"}, UnitPrefix{1e6, "M"}, UnitPrefix{1e3, "k"},
                                   UnitPrefix{1.0, ""}, UnitPrefix{1e-3, "m"}, UnitPrefix{1e-6, "µ"}}) {
    if (largest >= prefix.size) return prefix;
  }
  return largest > 0.0 ? UnitPrefix{1e-9, "n"} : UnitPrefix{1.0, ""};
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

std::string name_in(const std::string& column) {
  std::string name = column.substr(0, column.rfind('_'));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Axis axis_of(const std::string& column, const std::vector<double>& values) {
  const std::size_t cut = column.rfind('_');
  const std::string unit = cut == std::string::npos ? "" : column.substr(cut + 1);
  const UnitPrefix prefix = unit == "s" ? UnitPrefix{1.0, ""} : prefix_for(largest_of(values));
  return {column, fmt::format("{} ({}{})", name_in(column), prefix.sign, unit), 1.0 / prefix.size};
}

}  // namespace ligament
