#pragma once

#include <array>
#include <cstddef>

namespace ligament {

/// 1/k! for k = 0 to 13.
inline constexpr std::array<double, 14> inverse_factorials = [] {
  std::array<double, 14> values{1.0};
  double factorial = 1.0;
  for (std::size_t k = 1; k < values.size(); ++k) values[k] = 1.0 / (factorial *= static_cast<double>(k));
  return values;
}();

/// e^x for |x| < 700. Only + - × ÷ are used: the exponential functions of C libraries differ between processors, and
/// runs must not.
inline double exponential(double x) {
  // ln 2 in two parts: the product of the first with a whole number has no rounding.
  constexpr double ln2_high = 0x1.62e42fee00000p-1;
  constexpr double ln2_low = 0x1.a39ef35793c76p-33;
  constexpr double inverse_ln2 = 0x1.71547652b82fep+0;
  int doublings = static_cast<int>(x * inverse_ln2 + (x < 0.0 ? -0.5 : 0.5));
  const double rest = (x - doublings * ln2_high) - doublings * ln2_low;
  // Taylor series, |rest| < 0.35: the first term left out is below 1e-17 of the sum.
  double result = 0.0;
  for (std::size_t k = inverse_factorials.size(); k-- > 0;) result = result * rest + inverse_factorials[k];
  for (; doublings > 0; --doublings) result *= 2.0;
  for (; doublings < 0; ++doublings) result *= 0.5;
  return result;
}

}  // namespace ligament
