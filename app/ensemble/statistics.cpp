#include "ensemble/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligament {

Statistics statistics_of(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double deviation =
      values.size() > 1 ? std::sqrt(squares / (n - 1.0)) : std::numeric_limits<double>::quiet_NaN();
  return {values.size(), mean, deviation, *min, *max};
}

}  // namespace ligament
