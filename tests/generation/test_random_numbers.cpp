#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generation/random_numbers.hpp"

using namespace ligament;

namespace {

constexpr int n_draws = 100000;

/// Mean of draws, which must all lie in [from, to).
template <class Draw>
double mean_within(double from, double to, Draw&& draw) {
  double sum = 0.0;
  for (int i = 0; i < n_draws; ++i) {
    const double value = draw();
    REQUIRE(value >= from);
    REQUIRE(value < to);
    sum += value;
  }
  return sum / n_draws;
}

}  // namespace

TEST_CASE("the engine is that of the standard") {
  // C++20 [rand.predef]: the 10000th number of a default-constructed mt19937_64, whose seed is 5489.
  RandomNumbers random(5489);
  for (int i = 0; i < 9999; ++i) random.unit();
  CHECK(random.unit() == static_cast<double>(9981545732273789042ULL >> 11) * 0x1.0p-53);
}

TEST_CASE("uniform numbers have the mean and the variance of their range") {
  RandomNumbers random(1);
  // Bounds: four standard errors.
  const double deviation = 3.0 / std::sqrt(12.0);
  CHECK(std::abs(mean_within(2.0, 5.0, [&] { return random.uniform(2.0, 5.0); }) - 3.5) <
        4.0 * deviation / std::sqrt(n_draws));
  const double mean_square = mean_within(0.0, 1.0, [&] {
    const double u = random.unit();
    return u * u;
  });
  CHECK(std::abs(mean_square - 1.0 / 3.0) < 4.0 * std::sqrt(1.0 / 5.0 - 1.0 / 9.0) / std::sqrt(n_draws));
}

TEST_CASE("log-uniform numbers have the mean (b - a) / ln(b/a) and the median sqrt(a b)") {
  RandomNumbers random(2);
  const double from = 0.5;
  const double to = 4.0;
  const double log_ratio = std::log(to / from);
  const double expected = (to - from) / log_ratio;
  const double variance = 0.5 * (to * to - from * from) / log_ratio - expected * expected;
  CHECK(std::abs(mean_within(from, to, [&] { return random.log_uniform(from, to); }) - expected) <
        4.0 * std::sqrt(variance / n_draws));
  int n_below = 0;
  for (int i = 0; i < n_draws; ++i) n_below += random.log_uniform(from, to) < std::sqrt(from * to) ? 1 : 0;
  CHECK(std::abs(n_below - 0.5 * n_draws) < 4.0 * 0.5 * std::sqrt(n_draws));
}

TEST_CASE("a range of one value gives it") {
  RandomNumbers random(3);
  CHECK(random.uniform(0.02, 0.02) == 0.02);
}
