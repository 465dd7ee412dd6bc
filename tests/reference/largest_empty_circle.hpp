#pragma once

#include <algorithm>
#include <limits>

#include "core/vector.hpp"

namespace ligament::reference {

/// Distance (m) from a point to the nearest disc or to the border strip of the box [0, size]; < 0 inside of either.
inline double clearance(const Field<Vector>& centres, const Field<double>& radii, const Vector& size,
                        const Vector& point, double border = 0.0) {
  double least = std::min({point.x, point.y, size.x - point.x, size.y - point.y}) - border;
  for (std::size_t i = 0; i < centres.size(); ++i) least = std::min(least, norm(point - centres[i]) - radii[i]);
  return least;
}

/// Radius (m) of the largest empty circle with its centre on a grid of this spacing: that of the largest one of all is
/// greater by spacing/√2 at most.
inline double largest_empty_circle(const Field<Vector>& centres, const Field<double>& radii, const Vector& size,
                                   double spacing, double border = 0.0) {
  double largest = -std::numeric_limits<double>::infinity();
  for (double x = 0.5 * spacing; x < size.x; x += spacing) {
    for (double y = 0.5 * spacing; y < size.y; y += spacing) {
      largest = std::max(largest, clearance(centres, radii, size, {x, y}, border));
    }
  }
  return largest;
}

}  // namespace ligament::reference
