#pragma once

#include <algorithm>
#include <concepts>

#include "constitutive/exponential.hpp"

namespace ligament {

/// How the strength of a contact falls with its inelastic displacement w: f s(x), x = w f/G. Every curve begins at
/// s(0) = 1, has the area 1 in all, so that G is spent per area whatever f, and is zero from end() on.
/// intersection(a, r) solves x + a s(x) = r, limit and w of a step together: r is what the contact is moved by and a
/// s(x) what its spring takes of that. It is unique for a · steepest() <= 1, else the contact would snap.
template <class Curve>
concept SofteningCurve = requires(const Curve curve, double x) {
  { curve.strength(x) } -> std::same_as<double>;         // s(x)
  { curve.area(x) } -> std::same_as<double>;             // ∫s from 0 to x
  { curve.end() } -> std::same_as<double>;               // least x with s = 0
  { curve.slope(x) } -> std::same_as<double>;            // -s'(x)
  { curve.steepest() } -> std::same_as<double>;          // largest -s'
  { curve.is_straight(x, x) } -> std::same_as<bool>;     // whether s is a straight line between the two
  { curve.opening_at(x) } -> std::same_as<double>;       // least x with s no larger than the argument
  { curve.intersection(x, x) } -> std::same_as<double>;  // at most end()
};

/// Two straight lines that meet at a kink, the second down to zero at the end that makes the area 1. The defaults are
/// the one-fourth law of Rokugo et al. (1989): s = 1/4 at x = 3/4, zero at 5. Petersson's one-third law is s = 1/3 at
/// 4/5.
struct BilinearCurve {
  double kink_opening = 0.75;   ///< x of the kink, in (0, 1]
  double kink_strength = 0.25;  ///< s of the kink, in (0, 1)

  [[nodiscard]] double end() const {
    return kink_opening + (2.0 - kink_opening * (1.0 + kink_strength)) / kink_strength;
  }
  [[nodiscard]] double strength(double x) const {
    if (x < kink_opening) return 1.0 - first_slope() * x;
    return second_slope() * std::max(0.0, end() - x);
  }
  [[nodiscard]] double area(double x) const {
    if (x < kink_opening) return x * (1.0 - 0.5 * first_slope() * x);
    const double left = std::max(0.0, end() - x);
    return 1.0 - 0.5 * second_slope() * left * left;
  }
  [[nodiscard]] double slope(double x) const {
    if (x < kink_opening) return first_slope();
    return x < end() ? second_slope() : 0.0;
  }
  [[nodiscard]] double steepest() const { return std::max(first_slope(), second_slope()); }
  [[nodiscard]] bool is_straight(double from, double to) const {
    return to <= kink_opening || (from >= kink_opening && to <= end());
  }
  [[nodiscard]] double opening_at(double s) const {
    return s > kink_strength ? (1.0 - s) / first_slope() : end() - s / second_slope();
  }
  [[nodiscard]] double intersection(double a, double r) const {
    if (r < kink_opening + a * kink_strength) return (r - a) / (1.0 - a * first_slope());
    if (r >= end()) return end();
    return (r - a * second_slope() * end()) / (1.0 - a * second_slope());
  }

 private:
  [[nodiscard]] double first_slope() const { return (1.0 - kink_strength) / kink_opening; }
  [[nodiscard]] double second_slope() const { return kink_strength / (end() - kink_opening); }
};

/// s = e^-x, which has no end of its own: from x = 5 on (s = 0.0067) a straight line falls to zero at 7. The triangle
/// below it is what e^-x has still to give, so that the area is 1.
struct ExponentialCurve {
  static constexpr double tail = 5.0;

  [[nodiscard]] double end() const { return tail + 2.0; }
  [[nodiscard]] double strength(double x) const {
    return x < tail ? exponential(-x) : tail_slope() * std::max(0.0, end() - x);
  }
  [[nodiscard]] double area(double x) const {
    if (x < tail) return 1.0 - exponential(-x);
    const double left = std::max(0.0, end() - x);
    return 1.0 - 0.5 * tail_slope() * left * left;
  }
  [[nodiscard]] double slope(double x) const {
    if (x < tail) return exponential(-x);
    return x < end() ? tail_slope() : 0.0;
  }
  [[nodiscard]] double steepest() const { return 1.0; }
  [[nodiscard]] bool is_straight(double from, double to) const { return from >= tail && to <= end(); }
  [[nodiscard]] double opening_at(double s) const {
    if (s <= 2.0 * tail_slope()) return end() - s / tail_slope();
    // Newton from the left; the curve is convex, so that no step goes too far.
    double x = 0.0;
    for (int i = 0; i < most_iterations; ++i) {
      const double step = 1.0 - s / exponential(-x);
      x += step;
      if (step < rounding) break;
    }
    return x;
  }
  [[nodiscard]] double intersection(double a, double r) const {
    if (r >= end()) return end();
    // Newton from the right, x <= r; x + a s(x) is convex, so that no step goes too far.
    double x = r;
    for (int i = 0; i < most_iterations; ++i) {
      const double s = strength(x);
      const double slope = x < tail ? -s : -tail_slope();
      const double excess = x + a * s - r;
      if (excess < rounding) break;
      x -= excess / (1.0 + a * slope);
    }
    return x;
  }

 private:
  static constexpr int most_iterations = 60;
  static constexpr double rounding = 1e-15;
  /// Half of the strength e^-5 at the beginning of the tail.
  [[nodiscard]] static double tail_slope() { return 0.5 * exponential(-tail); }
};

}  // namespace ligament
