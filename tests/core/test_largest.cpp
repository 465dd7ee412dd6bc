#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/largest.hpp"

using ligament::Largest;

namespace {

double largest_of(std::initializer_list<double> numbers) {
  Largest largest;
  for (const double number : numbers) largest.see(number);
  return largest.value();
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("the largest of numbers from zero to infinity") {
  CHECK(largest_of({}) == 0.0);
  CHECK(largest_of({0.0, 3.0, 5e-324, 2.5}) == 3.0);
  CHECK(largest_of({1e-300, 5e-324}) == 1e-300);
  CHECK(largest_of({std::nextafter(1.0, 2.0), 1.0}) == std::nextafter(1.0, 2.0));
  CHECK(largest_of({1.0, infinite, 1e308}) == infinite);
}

TEST_CASE("what is not a number is larger than all, whatever its sign and place") {
  CHECK(std::isnan(largest_of({no_number, 1.0, infinite})));
  CHECK(std::isnan(largest_of({1.0, -no_number, 2.0})));
  CHECK(std::isnan(largest_of({1.0, infinite - infinite})));
}

TEST_CASE("largest numbers of parts join") {
  Largest all;
  Largest part;
  all.see(2.0);
  part.see(7.0);
  all += part;
  CHECK(all.value() == 7.0);
  all += Largest{};
  CHECK(all.value() == 7.0);
}
