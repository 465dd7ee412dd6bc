#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "ensemble/statistics.hpp"

using namespace ligament;

TEST_CASE("statistics of a sample, by hand") {
  // Mean 5; squares of what is left 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32, over 7.
  const std::array<double, 8> values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  const Statistics of = statistics_of(values);
  CHECK(of.n == 8);
  CHECK(of.mean == 5.0);
  CHECK(of.standard_deviation == doctest::Approx(std::sqrt(32.0 / 7.0)));
  CHECK(of.min == 2.0);
  CHECK(of.max == 9.0);
}

TEST_CASE("a single value has no deviation") {
  const std::array<double, 1> value{-3.0};
  const Statistics of = statistics_of(value);
  CHECK(of.mean == -3.0);
  CHECK(of.min == -3.0);
  CHECK(of.max == -3.0);
  CHECK(std::isnan(of.standard_deviation));
}
