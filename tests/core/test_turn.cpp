#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "core/turn.hpp"

using namespace ligament;

TEST_CASE("the angle of a sine and a cosine, over the whole circle") {
  constexpr int n_angles = 200'000;
  double largest_error = 0.0;
  for (int i = -n_angles + 1; i < n_angles; ++i) {
    const double angle = std::numbers::pi * i / n_angles;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const double exact = std::atan2(sine, cosine);
    largest_error =
        std::max(largest_error, std::abs(turn_angle(sine, cosine) - exact) / std::max(1.0, std::abs(exact)));
  }
  CHECK(largest_error < 1e-15);
}

TEST_CASE("small turns keep their relative accuracy") {
  for (double angle = 1.0; angle > 1e-300; angle *= 0.37) {
    const double exact = std::atan2(std::sin(angle), std::cos(angle));
    CHECK(std::abs(turn_angle(std::sin(angle), std::cos(angle)) - exact) <= 1e-15 * exact);
  }
}

TEST_CASE("turns close to a half circle") {
  for (double rest = 1.0; rest > 1e-14; rest *= 0.37) {
    const double sine = std::sin(rest);
    const double cosine = -std::cos(rest);
    CHECK(std::abs(turn_angle(sine, cosine) - std::atan2(sine, cosine)) < 1e-15);
    CHECK(turn_angle(-sine, cosine) == -turn_angle(sine, cosine));
  }
  CHECK(turn_angle(0.0, -1.0) == doctest::Approx(std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("a common factor of sine and cosine does not matter") {
  for (const double factor : {1e-12, 0.25, 3.0, 1e12}) {
    CHECK(turn_angle(factor * 0.6, factor * 0.8) == doctest::Approx(std::atan2(0.6, 0.8)).epsilon(1e-15));
  }
  CHECK(turn_angle(0.0, 0.0) == 0.0);
}
