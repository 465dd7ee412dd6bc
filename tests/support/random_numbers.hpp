#pragma once

#include <numbers>
#include <random>

#include "core/vector.hpp"

namespace ligament::support {

/// Random numbers that are the same everywhere: the engine is fixed by the standard, distributions are not.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  Vector vector(double half_width) {
    const double x = uniform(-half_width, half_width);
    return {x, uniform(-half_width, half_width)};
  }
  Vector direction() {
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace ligament::support
