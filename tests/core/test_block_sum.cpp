#include <doctest/doctest.h>

#include <cmath>

#include "core/block_sum.hpp"

using namespace ligament;

namespace {

/// Terms whose sum depends on the order of the additions.
double term(std::size_t i) {
  return std::sin(1.7 * static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 13));
}

double sum_by_blocks(std::size_t count) {
  double total = 0.0;
  for (std::size_t block = 0; block * block_size < count; ++block) {
    double partial = 0.0;
    for (std::size_t i = block * block_size; i < count && i < (block + 1) * block_size; ++i) partial += term(i);
    total += partial;
  }
  return total;
}

double sum_in_a_row(std::size_t count) {
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) total += term(i);
  return total;
}

}  // namespace

TEST_CASE("sums go by blocks, then over blocks") {
  for (const std::size_t count : {1u, 511u, 512u, 513u, 1024u, 5000u})
    CHECK(block_sum(count, term) == sum_by_blocks(count));
  CHECK(block_sum(5000, term) != sum_in_a_row(5000));
}

TEST_CASE("a sum over nothing is zero") { CHECK(block_sum(0, term) == 0.0); }

TEST_CASE("whatever can be added can be summed") {
  struct Pair {
    double a = 0.0;
    int b = 0;
    Pair& operator+=(const Pair& other) {
      a += other.a;
      b += other.b;
      return *this;
    }
  };
  const Pair sum = block_sum(1000, [](std::size_t) { return Pair{0.5, 2}; });
  CHECK(sum.a == 500.0);
  CHECK(sum.b == 2000);
}
