#pragma once

#include <algorithm>

#include "core/vector.hpp"

namespace ligament {

/// An axis-parallel rectangle (m).
struct Rectangle {
  Vector from;
  Vector to;

  [[nodiscard]] Vector size() const { return to - from; }
};

/// The share of the line from a to b that lies inside (Liang and Barsky).
inline double share_inside(const Rectangle& region, const Vector& a, const Vector& b) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < dimension; ++axis) {
    const double start = component(a, axis);
    const double along = component(b, axis) - start;
    const double low = component(region.from, axis) - start;
    const double high = component(region.to, axis) - start;
    if (along == 0.0) {
      if (low > 0.0 || high < 0.0) return 0.0;
      continue;
    }
    enter = std::max(enter, std::min(low / along, high / along));
    leave = std::min(leave, std::max(low / along, high / along));
  }
  return std::max(0.0, leave - enter);
}

}  // namespace ligament
