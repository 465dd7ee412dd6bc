#include "integrator/piecewise_linear.hpp"

#include <algorithm>

namespace ligament {

double PiecewiseLinear::value(double time) const {
  const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  if (after == 0) return values.front();
  if (after == times.size()) return values.back();
  const double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
  return values[after - 1] + share * (values[after] - values[after - 1]);
}

double PiecewiseLinear::mean_slope(double begin, double end) const {
  if (end <= times.front() || begin >= times.back()) return 0.0;
  const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), begin) - times.begin());
  // On one line it is the same wherever one looks, to the last digit.
  if (after > 0 && after < times.size() && end <= times[after]) {
    return (values[after] - values[after - 1]) / (times[after] - times[after - 1]);
  }
  return (value(end) - value(begin)) / (end - begin);
}

}  // namespace ligament
