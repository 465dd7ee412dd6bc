#include <doctest/doctest.h>

#include <cmath>

#include "constitutive/softening_curve.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr BilinearCurve petersson{0.8, 1.0 / 3.0};

/// Midpoint rule, wrong at a kink by an eighth of the square of an interval.
template <class Curve>
double integral(const Curve& curve, double to) {
  constexpr int n = 200000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += curve.strength(to * (i + 0.5) / n);
  return sum * to / n;
}

template <class Curve>
void check_curve(const Curve& curve) {
  CHECK(curve.strength(0.0) == 1.0);
  CHECK(curve.area(0.0) == 0.0);
  CHECK(curve.strength(curve.end()) == doctest::Approx(0.0).scale(1.0).epsilon(1e-15));
  CHECK(curve.strength(2.0 * curve.end()) == 0.0);
  CHECK(curve.area(curve.end()) == 1.0);
  CHECK(curve.area(3.0 * curve.end()) == 1.0);
  double steepest = 0.0;
  for (int i = 1; i <= 40; ++i) {
    const double x = curve.end() * i / 40;
    CHECK(curve.area(x) == doctest::Approx(integral(curve, x)).epsilon(1e-9));
    const double s = curve.strength(x);
    CHECK(curve.opening_at(s) == doctest::Approx(x).epsilon(1e-12));
    CHECK(s <= curve.strength(0.999 * x));
    steepest = std::max(steepest, (curve.strength(0.0) - curve.strength(1e-6)) / 1e-6);
  }
  CHECK(curve.steepest() == doctest::Approx(steepest).epsilon(1e-5));
}

template <class Curve>
void check_intersections(const Curve& curve, std::uint64_t seed) {
  RandomNumbers random(seed);
  for (int i = 0; i < 20000; ++i) {
    const double a = random.uniform(0.0, 1.0) / curve.steepest();
    const double r = random.uniform(a, 1.2 * curve.end());
    CAPTURE(a);
    CAPTURE(r);
    const double x = curve.intersection(a, r);
    if (r >= curve.end()) {
      REQUIRE(x == curve.end());
    } else {
      REQUIRE(x >= 0.0);
      REQUIRE(x + a * curve.strength(x) == doctest::Approx(r).epsilon(1e-14).scale(1.0));
    }
  }
}

}  // namespace

TEST_CASE("a softening curve falls from 1 to 0, and the area below it is 1") {
  check_curve(BilinearCurve{});
  check_curve(petersson);
  check_curve(BilinearCurve{0.9, 0.1});
  check_curve(ExponentialCurve{});
}

TEST_CASE("the bilinear curves of Rokugo and of Petersson") {
  CHECK(BilinearCurve{}.end() == doctest::Approx(5.0).epsilon(1e-15));
  CHECK(BilinearCurve{}.strength(0.75) == doctest::Approx(0.25).epsilon(1e-15));
  CHECK(BilinearCurve{}.steepest() == doctest::Approx(1.0).epsilon(1e-15));
  CHECK(petersson.end() == doctest::Approx(3.6).epsilon(1e-15));
  CHECK(petersson.strength(0.8) == doctest::Approx(1.0 / 3.0).epsilon(1e-15));
  CHECK(petersson.steepest() == doctest::Approx(5.0 / 6.0).epsilon(1e-15));
}

TEST_CASE("the exponential curve is one up to its tail, which goes on without a jump") {
  const ExponentialCurve curve;
  for (double x = 0.0; x < 5.0; x += 0.01) CHECK(curve.strength(x) == doctest::Approx(std::exp(-x)).epsilon(1e-14));
  CHECK(curve.strength(5.0) == doctest::Approx(std::exp(-5.0)).epsilon(1e-14));
  CHECK(curve.area(5.0) == doctest::Approx(1.0 - std::exp(-5.0)).epsilon(1e-14));
}

TEST_CASE("limit and opening of a step fulfil both equations, up to the steepest spring that is allowed") {
  check_intersections(BilinearCurve{}, 31);
  check_intersections(petersson, 32);
  check_intersections(ExponentialCurve{}, 33);
}

TEST_CASE("a spring as steep as the curve itself is still served") {
  // The whole first line of Rokugo's curve is one point of force and displacement: the far end of it is taken.
  CHECK(BilinearCurve{}.intersection(1.0, 1.0 + 1e-12) == doctest::Approx(0.75).epsilon(1e-9));
  const double x = ExponentialCurve{}.intersection(1.0, 1.0 + 1e-8);
  CHECK(x + std::exp(-x) == doctest::Approx(1.0 + 1e-8).epsilon(1e-14));
}

TEST_CASE("the exponential function is that of the C library, to rounding") {
  RandomNumbers random(34);
  double largest = 0.0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = i < 500000 ? random.uniform(-8.0, 0.0) : random.uniform(-690.0, 690.0);
    const double exact = std::exp(x);
    largest = std::max(largest, std::abs(exponential(x) - exact) / exact);
  }
  CHECK(largest < 1e-15);
  CHECK(exponential(0.0) == 1.0);
}
