#pragma once

#include <cstdint>
#include <random>

namespace ligament {

/// Random numbers that are the same on every machine: the standard fixes the engine, and what is made of its output
/// here needs nothing of the C library.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  /// Uniform in [from, to).
  double uniform(double from, double to) { return from + (to - from) * unit(); }

  /// Density ~ 1/r in [from, to), from > 0. By rejection, because a logarithm differs between C libraries.
  double log_uniform(double from, double to) {
    for (;;) {
      const double candidate = uniform(from, to);
      if (unit() * candidate < from) return candidate;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace ligament
