#include <doctest/doctest.h>

#include <algorithm>

#include "generation/disc_insertion.hpp"
#include "generation/soft_discs.hpp"

using namespace ligament;

namespace {

/// Resultants on all discs from all pairs and walls: the slow twin.
Field<Vector> resultants(const Field<Vector>& centres, const Field<double>& radii, const Vector& size) {
  Field<Vector> forces(centres.size());
  for (std::size_t a = 0; a < centres.size(); ++a) {
    for (std::size_t b = 0; b < centres.size(); ++b) {
      const Vector apart = centres[a] - centres[b];
      const double overlap = radii[a] + radii[b] - norm(apart);
      if (a != b && overlap > 0.0) forces[a] += overlap / norm(apart) * apart;
    }
    for (int axis = 0; axis < dimension; ++axis) {
      const double low = component(centres[a], axis);
      const double high = component(size, axis) - low;
      Vector push;
      set_component(push, axis, 2.0 * std::max(0.0, radii[a] - low) - 2.0 * std::max(0.0, radii[a] - high));
      forces[a] += push;
    }
  }
  return forces;
}

}  // namespace

TEST_CASE("a row of equal discs between walls comes to even distances, those to the mirror images included") {
  const Vector size{0.9, 0.18};
  const Field<double> radii(5, 0.1);
  SoftDiscs discs({{0.05, 0.09}, {0.3, 0.085}, {0.45, 0.09}, {0.6, 0.1}, {0.88, 0.09}}, size);
  CHECK(discs.relax(radii, 1e-12, 10000) < 10000);
  for (int i = 0; i < 5; ++i) {
    CHECK(discs.centres()[i].x == doctest::Approx(0.09 + 0.18 * i).epsilon(1e-10));
    CHECK(discs.centres()[i].y == doctest::Approx(0.09).epsilon(1e-10));
  }
}

TEST_CASE("discs that overlap in a wide box part until they touch no more, and go no farther") {
  SoftDiscs discs({{0.45, 0.5}, {0.55, 0.5}}, {1.0, 1.0});
  discs.relax({0.1, 0.1}, 1e-9, 10000);
  const double distance = norm(discs.centres()[1] - discs.centres()[0]);
  CHECK(distance >= 0.2 * (1.0 - 1e-9));
  CHECK(distance < 0.21);
  CHECK(norm(discs.centres()[1] + discs.centres()[0] - Vector{1.0, 1.0}) < 1e-12);
}

TEST_CASE("discs that do not overlap stay where they are") {
  const Field<Vector> centres{{0.2, 0.2}, {0.8, 0.7}};
  SoftDiscs discs(centres, {1.0, 1.0});
  CHECK(discs.relax({0.1, 0.2}, 1e-9, 100) == 0);
  CHECK(discs.centres() == centres);
}

TEST_CASE("a disc wider than the box comes to its middle") {
  SoftDiscs discs({{0.1, 0.3}}, {0.5, 0.4});
  discs.relax({0.3}, 1e-12, 10000);
  CHECK(norm(discs.centres()[0] - Vector{0.25, 0.2}) < 1e-12);
}

TEST_CASE("squeezed discs come to rest: no resultant is larger than the tolerance allows") {
  const Vector size{1.0, 0.8};
  RandomNumbers random(7);
  Field<double> radii;
  for (int i = 0; i < 300; ++i) radii.push_back(random.uniform(0.01, 0.05));
  std::sort(radii.rbegin(), radii.rend());
  Field<double> small = radii;
  for (double& radius : small) radius *= 0.3;
  SoftDiscs discs(insert_discs(small, size, random), size);
  const double tolerance = 1e-6;
  CHECK(discs.relax(radii, tolerance, 20000) < 20000);
  double sum = 0.0;
  for (const double radius : radii) sum += radius;
  const double mean_radius = sum / 300.0;
  for (const Vector& force : resultants(discs.centres(), radii, size)) {
    CHECK(largest_component(force) <= tolerance * mean_radius * (1.0 + 1e-6));
  }
}
