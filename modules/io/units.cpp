#include "io/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "io/unit_system.hpp"

namespace ligament {

namespace {

struct Dimension {
  const char* unit;
  const char* name;
  const char* example;
};

constexpr std::array dimensions{
    Dimension{"Pa", "a stress", "20 GPa"},
    Dimension{"m", "a length", "5 mm"},
    Dimension{"m2", "an area", "100 mm2"},
    Dimension{"m4", "a second moment of area", "100 cm4"},
    Dimension{"s", "a time", "1 ms"},
    Dimension{"Hz", "a frequency", "50 Hz"},
    Dimension{"kg", "a mass", "2 kg"},
    Dimension{"N", "a force", "1.65 kN"},
    Dimension{"N*m", "a moment or an energy", "10 N*m"},
    Dimension{"N/m", "a force or an energy per length or area", "70 N/m"},
    Dimension{"Pa/m", "a stress per length", "1 GPa/m"},
    Dimension{"kg/m3", "a density", "2400 kg/m3"},
    Dimension{"m/s", "a velocity", "2 um/s"},
    Dimension{"m/s2", "an acceleration", "9.81 m/s2"},
    Dimension{"rad", "an angle", "30 deg"},
};

const Dimension* dimension_of(std::string_view unit) {
  const UnitSystem& system = UnitSystem::instance();
  for (const Dimension& candidate : dimensions) {
    if (system.same_dimension(candidate.unit, unit)) return &candidate;
  }
  return nullptr;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The micro sign and the Greek mu, which look alike, as "u".
std::string in_ascii(std::string_view unit) {
  std::string ascii;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::string_view pair = unit.substr(i, 2);
    const bool is_micro = pair == "\xC2\xB5" || pair == "\xCE\xBC";
    ascii += is_micro ? 'u' : unit[i];
    if (is_micro) ++i;
  }
  return ascii;
}

/// Whether the text is `name[^][-]digit` joined by `*` and `/`. UDUNITS would take far more: "3 m 2" as 6 m, dates,
/// logs.
bool is_well_formed_unit(std::string_view text) {
  std::size_t i = 0;
  const auto skip = [&](char c) {
    const bool found = i < text.size() && text[i] == c;
    if (found) ++i;
    return found;
  };
  do {
    const std::size_t name_begin = i;
    while (i < text.size() && is_letter(text[i])) ++i;
    if (i == name_begin) return false;
    const bool caret = skip('^');
    const bool minus = skip('-');
    const std::size_t exponent_begin = i;
    while (i < text.size() && is_digit(text[i])) ++i;
    const std::size_t n_digits = i - exponent_begin;
    if (n_digits > 1 || ((caret || minus) && n_digits == 0)) return false;
  } while (skip('*') || skip('/'));
  return i == text.size();
}

std::optional<double> whole_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// The double nearest to (decimal number) * 10^shift: the exponent is moved in the text, so there is one rounding.
double shifted(std::string_view number, int shift) {
  const std::size_t e = number.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    const std::size_t sign = number.substr(e + 1, 1) == "+" ? 1 : 0;
    std::from_chars(number.data() + e + 1 + sign, number.data() + number.size(), exponent);
  }
  const std::string text = fmt::format("{}e{}", number.substr(0, e), exponent + shift);
  return whole_number(text).value_or(HUGE_VAL);
}

/// UDUNITS multiplies prefixes in floating point: 999.9999999999999 for g/cm3. A factor that is within rounding of a
/// short decimal is that decimal.
std::string factor_text(double factor) {
  const std::string short_text = fmt::format("{:.10e}", factor);
  const double short_factor = whole_number(short_text).value_or(factor);
  return std::abs(short_factor - factor) <= 4e-15 * std::abs(factor) ? short_text : fmt::format("{:.17e}", factor);
}

double scaled(std::string_view number, double factor) {
  const std::string text = factor_text(factor);
  const std::size_t e = text.find('e');
  const std::string_view digits = std::string_view(text).substr(0, e);
  const bool is_power_of_ten =
      digits.find_first_not_of("10.") == std::string_view::npos && digits.find('1') == 0 && digits.rfind('1') == 0;
  if (is_power_of_ten) return shifted(number, std::stoi(text.substr(e + 1)));
  return *whole_number(number) * *whole_number(text);
}

struct SplitQuantity {
  std::string_view number;
  std::string unit;
};

SplitQuantity split(std::string_view text, std::string_view expected_unit) {
  const std::size_t space = text.find(' ');
  const std::string_view number = text.substr(0, space);
  if (!whole_number(number)) {
    throw UnitError(fmt::format("'{}' is not a finite number, one space and a unit: expected {}", text,
                                expected_quantity(expected_unit)));
  }
  if (space == std::string_view::npos) {
    throw UnitError(fmt::format("'{}' has no unit: expected {}", text, expected_quantity(expected_unit)));
  }
  SplitQuantity quantity{number, in_ascii(text.substr(space + 1))};
  if (!is_well_formed_unit(quantity.unit)) {
    throw UnitError(fmt::format("'{}': '{}' is not a unit (names with exponents, joined by '*' and '/'): expected {}",
                                text, quantity.unit, expected_quantity(expected_unit)));
  }
  return quantity;
}

}  // namespace

double to_si(std::string_view text, std::string_view unit) {
  const UnitSystem& system = UnitSystem::instance();
  if (!system.knows(unit)) throw std::logic_error(fmt::format("'{}' is no unit", unit));
  const SplitQuantity quantity = split(text, unit);
  if (!system.knows(quantity.unit)) {
    throw UnitError(fmt::format("'{}': unknown unit '{}': expected {}", text, quantity.unit, expected_quantity(unit)));
  }
  const std::optional<double> factor = system.factor(quantity.unit, unit);
  if (!factor) {
    const Dimension* measured = dimension_of(unit);
    const std::string what = measured != nullptr ? measured->name : fmt::format("measured in {}", unit);
    throw UnitError(fmt::format("'{}' is not {}: expected {}", text, what, expected_quantity(unit)));
  }
  const double value = scaled(quantity.number, *factor);
  if (!std::isfinite(value)) throw UnitError(fmt::format("'{}' is beyond the range of numbers in {}", text, unit));
  return value;
}

std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), end);
}

std::string si_text(double value, std::string_view unit) { return fmt::format("{} {}", shortest(value), unit); }

std::string example_quantity(std::string_view unit) {
  const Dimension* measured = dimension_of(unit);
  return measured != nullptr ? measured->example : fmt::format("1 {}", unit);
}

std::string expected_quantity(std::string_view unit) {
  return fmt::format("a quantity in {} (such as \"{}\")", unit, example_quantity(unit));
}

void check_unit(std::string_view unit) {
  if (!is_well_formed_unit(unit) || !UnitSystem::instance().knows(unit)) {
    throw UnitError(fmt::format("'{}' is not a unit this program reads", unit));
  }
}

}  // namespace ligament
