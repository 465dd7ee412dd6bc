#pragma once

#include <cstddef>
#include <span>

namespace ligament {

/// A number over several runs.
struct Statistics {
  std::size_t n = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< of a sample, √(Σ(x - mean)²/(n-1)); not a number if n = 1
  double min = 0.0;
  double max = 0.0;
};

/// Of at least one value.
Statistics statistics_of(std::span<const double> values);

}  // namespace ligament
