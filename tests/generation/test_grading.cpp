#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "generation/grading.hpp"

using namespace ligament;

TEST_CASE("diameters of a class follow the closed form of the density ~ 1/d²") {
  const SieveClass sieve_class{0.004, 0.008, 1.0};
  RandomNumbers random(11);
  constexpr std::size_t count = 100000;
  std::vector<double> diameters(count);
  for (double& diameter : diameters) diameter = draw_diameter(sieve_class, random);
  std::sort(diameters.begin(), diameters.end());
  CHECK(diameters.front() >= sieve_class.from);
  CHECK(diameters.back() < sieve_class.to);
  double largest_difference = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double distribution =
        (1.0 / sieve_class.from - 1.0 / diameters[i]) / (1.0 / sieve_class.from - 1.0 / sieve_class.to);
    largest_difference = std::max(largest_difference, std::abs(distribution - (static_cast<double>(i) + 0.5) / count));
  }
  // Kolmogorov: beyond 1.95/√n once in a thousand samples.
  CHECK(largest_difference < 1.95 / std::sqrt(static_cast<double>(count)));
}

TEST_CASE("the mass of a class is spread evenly over its diameters") {
  const SieveClass sieve_class{0.002, 0.004, 1.0};
  RandomNumbers random(12);
  constexpr int n_parts = 4;
  std::array<double, n_parts> mass{};
  double sum = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double diameter = draw_diameter(sieve_class, random);
    mass[static_cast<std::size_t>((diameter / 0.002 - 1.0) * n_parts)] += diameter * diameter;
    sum += diameter * diameter;
  }
  for (const double part : mass) CHECK(part / sum == doctest::Approx(1.0 / n_parts).epsilon(0.01));
}

TEST_CASE("grains of a class have the area that is asked for, to half a grain") {
  const SieveClass sieve_class{0.008, 0.012, 1.0};
  RandomNumbers random(13);
  for (const double area : {1e-3, 1e-2, 0.1}) {
    double sum = 0.0;
    for (const double radius : draw_grains(sieve_class, area, random)) sum += std::numbers::pi * radius * radius;
    CHECK(std::abs(sum - area) <= 0.5 * std::numbers::pi * 0.006 * 0.006);
  }
  CHECK(draw_grains(sieve_class, 0.0, random).empty());
}
