#pragma once

#include <cmath>
#include <numbers>

namespace ligament {

/// turn_angle() by halving, for any angle.
inline double large_turn_angle(double sine, double cosine) {
  // Close to ±π halving would lose the digits of 1 + c.
  if (cosine < 0.0) return std::copysign(std::numbers::pi, sine) - large_turn_angle(sine, -cosine);
  const double length = std::sqrt(sine * sine + cosine * cosine);
  if (length == 0.0) return 0.0;
  double s = sine / length;
  double c = cosine / length;
  double factor = 1.0;
  // Halve the angle until the series converges to rounding in a few terms.
  while (c < 0.995) {
    c = std::sqrt(0.5 * (1.0 + c));
    s /= 2.0 * c;
    factor *= 2.0;
  }
  const double q = s * s;
  // arcsine series, |s| < 0.1: the first term left out is below 1e-17 of the sum.
  const double series =
      1.0 + q * (1.0 / 6.0 +
                 q * (3.0 / 40.0 +
                      q * (5.0 / 112.0 +
                           q * (35.0 / 1152.0 + q * (63.0 / 2816.0 + q * (231.0 / 13312.0 + q * (143.0 / 10240.0)))))));
  return factor * s * series;
}

/// Whether small_turn_angle() will do. Bodies turn by little in a step.
inline bool is_small_turn(double sine, double cosine) { return std::abs(sine) < 0.01 * cosine; }

/// turn_angle() of small turns: no branches, and one division.
inline double small_turn_angle(double sine, double cosine) {
  const double tangent = sine / cosine;
  const double q = tangent * tangent;
  // arctangent series, |tangent| < 0.01: the first term left out is below 2e-17 of the sum.
  return tangent * (1.0 - q * (1.0 / 3.0 - q * (1.0 / 5.0 - q * (1.0 / 7.0))));
}

/// The angle (rad, within ±π) whose sine and cosine are given up to a common positive factor. Only + - × ÷ √ are used:
/// the inverse trigonometric functions of C libraries differ between processors, and runs must not.
inline double turn_angle(double sine, double cosine) {
  return is_small_turn(sine, cosine) ? small_turn_angle(sine, cosine) : large_turn_angle(sine, cosine);
}

}  // namespace ligament
