#include <doctest/doctest.h>

#include "run/uniaxial_results.hpp"

using namespace ligament;

TEST_CASE("a specimen with a triangular curve: strength, secant and the area below it") {
  // Up to 300 N along E A/L = 3e6 N/m, then down to zero at four times the elongation of the peak.
  const UniaxialTest test{.axis = 1, .length = 0.2, .area = 1e-4};
  std::vector<double> loads;
  std::vector<double> elongations;
  for (int i = 0; i <= 40; ++i) {
    elongations.push_back(1e-5 * i);
    loads.push_back(i <= 10 ? 30.0 * i : 300.0 * (40 - i) / 30.0);
  }
  const UniaxialResults results = uniaxial_results(test, loads, elongations);
  CHECK(results.strength == doctest::Approx(3e6).epsilon(1e-14));
  CHECK(results.young_modulus == doctest::Approx(3e6 * 0.2 / 1e-4).epsilon(1e-13));
  CHECK(results.fracture_energy == doctest::Approx(0.5 * 300.0 * 4e-4 / 1e-4).epsilon(1e-13));
}

TEST_CASE("the secant is taken at a third of the peak, between rows if need be") {
  const UniaxialTest test{.length = 1.0, .area = 1.0};
  // 20 of 60 lies in the middle of the second line.
  const UniaxialResults results = uniaxial_results(test, {0.0, 10.0, 30.0, 60.0}, {0.0, 1.0, 4.0, 10.0});
  CHECK(results.young_modulus == doctest::Approx(20.0 / 2.5).epsilon(1e-14));
}
