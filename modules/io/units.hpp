#pragma once

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace ligament {

/// A text that is no quantity of the unit asked for.
class UnitError : public InputError {
 public:
  using InputError::InputError;
};

/// The value in `unit` (a coherent SI unit such as "Pa", "kg/m3") of a quantity such as "21.9 GPa".
///
/// The text is a number, one space and a unit made of names with exponents joined by `*` and `/`. Where the units
/// differ by a power of ten the result is the double nearest to the decimal written; it has the same bits on every run.
/// Throws UnitError, saying which units would do; std::logic_error if `unit` itself is no unit.
[[nodiscard]] double to_si(std::string_view text, std::string_view unit);

/// The shortest text that to_si() turns into the same bits: "2.19e+10 Pa".
[[nodiscard]] std::string si_text(double value, std::string_view unit);

/// The shortest decimal that reads back as the same double.
[[nodiscard]] std::string shortest(double value);

/// What would do for a quantity of this unit: `a quantity in Pa (such as "20 GPa")`.
[[nodiscard]] std::string expected_quantity(std::string_view unit);

/// A quantity as a user would write it: `20 GPa` for Pa.
[[nodiscard]] std::string example_quantity(std::string_view unit);

/// Throws UnitError if the text is not a unit this program reads.
void check_unit(std::string_view unit);

}  // namespace ligament
