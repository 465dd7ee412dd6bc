#include <doctest/doctest.h>

#include "integrator/piecewise_linear.hpp"

using ligament::PiecewiseLinear;

TEST_CASE("straight lines between corners, constant beyond them") {
  const PiecewiseLinear line{{0.0, 1.0, 3.0}, {0.0, 2.0, -2.0}};
  CHECK(line.value(-1.0) == 0.0);
  CHECK(line.value(0.0) == 0.0);
  CHECK(line.value(0.25) == 0.5);
  CHECK(line.value(1.0) == 2.0);
  CHECK(line.value(2.0) == 0.0);
  CHECK(line.value(3.0) == -2.0);
  CHECK(line.value(1e9) == -2.0);
  CHECK(PiecewiseLinear{}.empty());
  CHECK_FALSE(line.empty());
}

TEST_CASE("mean slopes: that of a line within it, the difference of values across a corner") {
  const PiecewiseLinear line{{0.0, 1.0, 3.0}, {0.0, 0.1, -2.0}};
  // To the last digit, far from the corner as well.
  CHECK(line.mean_slope(0.9, 0.9 + 1e-9) == 0.1);
  CHECK(line.mean_slope(0.0, 1.0) == 0.1);
  CHECK(line.mean_slope(1.5, 1.5) == line.mean_slope(1.0, 3.0));
  CHECK(line.mean_slope(0.5, 2.0) == doctest::Approx((-0.95 - 0.05) / 1.5).epsilon(1e-14));
  CHECK(line.mean_slope(2.0, 4.0) == doctest::Approx((-2.0 + 0.95) / 2.0).epsilon(1e-14));
  CHECK(line.mean_slope(3.0, 4.0) == 0.0);
  CHECK(line.mean_slope(-2.0, 0.0) == 0.0);
  CHECK(line.mean_slope(5.0, 5.0) == 0.0);
}
