#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "ensemble/mean_curve.hpp"

using namespace ligament;

using Values = std::vector<double>;

TEST_CASE("the way forward leaves out unloading, snap-back and standstill") {
  const Values x{0.0, 1.0, 0.5, 0.8, 1.0, 2.0, 2.0, 3.0};
  const Values y{0.0, 10.0, 5.0, 6.0, 9.0, 12.0, 4.0, 2.0};
  const Curve curve = forward_part(x, y);
  CHECK(curve.abscissa == Values{0.0, 1.0, 2.0, 3.0});
  CHECK(curve.ordinate == Values{0.0, 10.0, 12.0, 2.0});
}

TEST_CASE("values between the points are on straight lines") {
  const Curve curve{{0.0, 1.0, 3.0}, {0.0, 10.0, 4.0}};
  CHECK(value_at(curve, 0.25) == 2.5);
  CHECK(value_at(curve, 1.0) == 10.0);
  CHECK(value_at(curve, 2.0) == 7.0);
  CHECK(value_at(curve, 3.0) == 4.0);
  CHECK(value_at(curve, -1.0) == 0.0);
  CHECK(value_at(curve, 5.0) == 4.0);
}

TEST_CASE("mean and band over the range that all curves share, by hand") {
  // y = 2 x up to 4, and y = 4 x from 1 to 3: together from 1 to 3.
  const std::array<Curve, 2> curves{Curve{{0.0, 4.0}, {0.0, 8.0}}, Curve{{1.0, 3.0}, {4.0, 12.0}}};
  const std::vector<BandPoint> band = band_of(curves, 3);
  REQUIRE(band.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = 1.0 + static_cast<double>(i);
    CHECK(band[i].abscissa == x);
    CHECK(band[i].ordinate.n == 2);
    CHECK(band[i].ordinate.mean == 3.0 * x);
    CHECK(band[i].ordinate.min == 2.0 * x);
    CHECK(band[i].ordinate.max == 4.0 * x);
    CHECK(band[i].ordinate.standard_deviation == doctest::Approx(std::sqrt(2.0) * x));
  }
}

TEST_CASE("curves that share no range have no band") {
  const std::array<Curve, 2> apart{Curve{{0.0, 1.0}, {0.0, 1.0}}, Curve{{1.0, 3.0}, {4.0, 12.0}}};
  CHECK(band_of(apart, 3).empty());
  const std::array<Curve, 1> none{Curve{}};
  CHECK(band_of(none, 3).empty());
  CHECK(band_of({}, 3).empty());
}
