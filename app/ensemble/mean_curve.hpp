#pragma once

#include <span>
#include <vector>

#include "ensemble/statistics.hpp"

namespace ligament {

/// An ordinate over an abscissa that ascends strictly.
struct Curve {
  std::vector<double> abscissa;
  std::vector<double> ordinate;
};

/// The points at which x is larger than at all points before: the way forward, without what is unloaded or snaps back.
Curve forward_part(std::span<const double> x, std::span<const double> y);

/// Linear between the points; at the ends' values beyond them.
double value_at(const Curve& curve, double x);

/// The curves together, at one abscissa.
struct BandPoint {
  double abscissa = 0.0;
  Statistics ordinate;
};

/// Statistics of the curves at `n_points` equal steps over the range that all of them share; nothing if there is none.
std::vector<BandPoint> band_of(std::span<const Curve> curves, std::size_t n_points);

}  // namespace ligament
