#pragma once

#include <vector>

namespace ligament {

/// Straight lines between corners, constant before the first and after the last one.
struct PiecewiseLinear {
  std::vector<double> times;   ///< ascending (s)
  std::vector<double> values;  ///< as many

  /// No corners: nothing is given.
  [[nodiscard]] bool empty() const { return times.empty(); }
  [[nodiscard]] double value(double time) const;
  /// Change of the value from one time to a later one, over the time between.
  [[nodiscard]] double mean_slope(double begin, double end) const;
};

}  // namespace ligament
