#pragma once

#include <cstddef>

namespace ligament {

/// Integral of a rate over [0, 1] by Simpson's rule, halving the intervals until the integral's `measure` changes by no
/// more than the tolerance, from `fewest` to 1024 of them. `begin` and `end` are the rates at 0 and 1.
template <class Value, class Rate, class Measure>
Value line_integral(const Value& begin, const Value& end, Rate&& rate, Measure&& measure, std::size_t fewest,
                    double tolerance) {
  constexpr std::size_t most_intervals = 1024;
  Value trapezoid = 0.5 * (begin + end);
  Value simpson = trapezoid;
  for (std::size_t n = 2; n <= most_intervals; n *= 2) {
    Value middles{};
    for (std::size_t i = 1; i < n; i += 2) middles += rate(static_cast<double>(i) / static_cast<double>(n));
    const Value finer = 0.5 * trapezoid + (1.0 / static_cast<double>(n)) * middles;
    const Value better = (4.0 / 3.0) * finer - (1.0 / 3.0) * trapezoid;
    const double change = measure(better) - measure(simpson);
    trapezoid = finer;
    simpson = better;
    if (n >= fewest && (change < 0.0 ? -change : change) <= tolerance) break;
  }
  return simpson;
}

}  // namespace ligament
