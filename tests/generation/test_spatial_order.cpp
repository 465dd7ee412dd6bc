#include <doctest/doctest.h>

#include <algorithm>

#include "generation/spatial_order.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

Packing random_packing(int count) {
  RandomNumbers random(28);
  Packing packing;
  for (int i = 0; i < count; ++i) {
    packing.position.push_back(random.vector(1.0));
    packing.radius.push_back(random.uniform(0.005, 0.02));
  }
  packing.report.push_back({"n_particles", static_cast<double>(count)});
  return packing;
}

/// Mean distance between discs that follow each other.
double mean_jump(const Packing& packing) {
  double sum = 0.0;
  for (std::size_t i = 1; i < packing.size(); ++i) sum += norm(packing.position[i] - packing.position[i - 1]);
  return sum / static_cast<double>(packing.size() - 1);
}

}  // namespace

TEST_CASE("sorting keeps every disc with its radius, and the report") {
  const Packing before = random_packing(500);
  Packing after = before;
  sort_spatially(after);
  REQUIRE(after.size() == before.size());
  CHECK(after.report.size() == 1);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto found = std::find(after.position.begin(), after.position.end(), before.position[i]);
    REQUIRE(found != after.position.end());
    CHECK(after.radius[found - after.position.begin()] == before.radius[i]);
  }
}

TEST_CASE("discs that follow each other are near each other") {
  Packing packing = random_packing(3000);
  const double before = mean_jump(packing);
  sort_spatially(packing);
  CHECK(mean_jump(packing) < 0.1 * before);
}

TEST_CASE("the order does not depend on the order before") {
  Packing packing = random_packing(300);
  Packing reversed = packing;
  std::reverse(reversed.position.begin(), reversed.position.end());
  std::reverse(reversed.radius.begin(), reversed.radius.end());
  sort_spatially(packing);
  sort_spatially(reversed);
  CHECK(packing.position == reversed.position);
  CHECK(packing.radius == reversed.radius);
}

TEST_CASE("an empty packing stays empty") {
  Packing packing;
  sort_spatially(packing);
  CHECK(packing.size() == 0);
}
