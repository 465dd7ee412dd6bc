#include <doctest/doctest.h>

#include <algorithm>

#include "run/macro_crack.hpp"
#include "run/plane_meeting.hpp"

using namespace ligament;

namespace {

constexpr double length = 2.0;

/// A broken plane of this direction through a point.
CrackPlane plane(const Vector& centre, const Vector& along, double energy = 1.0) {
  return {.centre = centre,
          .normal = -tangent(along),
          .length = length,
          .damage = 1.0,
          .mode = FractureMode::tension,
          .spent_energy = energy};
}

/// Planes end to end along x, the gap between them a share of their length.
std::vector<CrackPlane> row(int count, const Vector& from = {}, double gap = 0.0) {
  std::vector<CrackPlane> planes;
  for (int i = 0; i < count; ++i) {
    planes.push_back(plane(from + Vector{(0.5 + (1.0 + gap) * i) * length, 0.0}, {1.0, 0.0}));
  }
  return planes;
}

/// Planes end to end, up and down in turn with slope 3/4.
std::vector<CrackPlane> zigzag(int count) {
  std::vector<CrackPlane> planes;
  for (int i = 0; i < count; ++i) {
    planes.push_back(plane({(i + 0.5) * 0.8 * length, 0.3 * length}, {0.8, i % 2 == 0 ? 0.6 : -0.6}));
  }
  return planes;
}

MacroCrack crack_of(const std::vector<CrackPlane>& planes) {
  const auto crack = find_macro_crack(planes);
  REQUIRE(crack.has_value());
  return *crack;
}

double smaller_x(const MacroCrack& crack) { return std::min(crack.path.front().x, crack.path.back().x); }

}  // namespace

TEST_CASE("a straight row of planes is a crack of tortuosity 1") {
  const MacroCrack crack = crack_of(row(7));
  CHECK(crack.path.size() == 8);
  CHECK(crack.length == doctest::Approx(7.0 * length).epsilon(1e-14));
  CHECK(crack.tortuosity == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(smaller_x(crack) == 0.0);
  CHECK(crack.damaged_width == doctest::Approx(0.0));
}

TEST_CASE("a zigzag is longer than its span by one over the cosine of its angle") {
  const MacroCrack crack = crack_of(zigzag(10));
  CHECK(crack.length == doctest::Approx(10.0 * length).epsilon(1e-12));
  CHECK(norm(crack.path.back() - crack.path.front()) == doctest::Approx(8.0 * length).epsilon(1e-12));
  CHECK(crack.tortuosity == doctest::Approx(1.25).epsilon(1e-12));
}

TEST_CASE("a single plane is a crack of its own length, and without planes there is none") {
  const MacroCrack crack = crack_of(row(1));
  CHECK(crack.length == doctest::Approx(length));
  CHECK(crack.tortuosity == doctest::Approx(1.0));
  CHECK_FALSE(find_macro_crack({}).has_value());
}

TEST_CASE("planes are connected up to a gap of half the shorter one") {
  CHECK(crack_of(row(4, {}, 0.499)).length == doctest::Approx((4.0 + 3.0 * 0.499) * length));
  CHECK(crack_of(row(4, {}, 0.501)).length == doctest::Approx(length));
}

TEST_CASE("the set that spans most is taken, side branches and the order of the planes make no difference") {
  std::vector<CrackPlane> planes = row(3, {0.0, 20.0});
  for (const CrackPlane& other : row(6)) planes.push_back(other);
  // A branch that leaves the row at its middle.
  planes.push_back(plane({3.0 * length, 0.5 * length}, {0.0, 1.0}));
  planes.push_back(plane({3.0 * length, 1.5 * length}, {0.0, 1.0}));
  CHECK(crack_of(planes).length == doctest::Approx(6.0 * length).epsilon(1e-14));
  std::reverse(planes.begin(), planes.end());
  CHECK(crack_of(planes).length == doctest::Approx(6.0 * length).epsilon(1e-14));
  CHECK(crack_of(planes).tortuosity == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE("planes that have lost no more than nine tenths interrupt the crack") {
  std::vector<CrackPlane> planes = row(5);
  planes[3].damage = 0.91;
  CHECK(crack_of(planes).length == doctest::Approx(5.0 * length));
  planes[3].damage = 0.9;
  CHECK(crack_of(planes).length == doctest::Approx(3.0 * length));
}

TEST_CASE("the damaged width leaves a twentieth of the energy on either side") {
  std::vector<CrackPlane> planes = row(10);
  for (CrackPlane& broken : planes) broken.spent_energy = 0.0;
  // 101 equal shares at distances 0.1, 0.2 … 10.1, below and above in turn: five lie below -9.1, five above 9.
  for (int i = 1; i <= 101; ++i) {
    CrackPlane damaged = plane({0.17 * i, i % 2 == 0 ? 0.1 * i : -0.1 * i}, {1.0, 0.0});
    damaged.damage = 0.3;
    planes.push_back(damaged);
  }
  CHECK(crack_of(planes).damaged_width == doctest::Approx(18.1).epsilon(1e-12));

  // What lies beyond the ends does not count.
  CrackPlane beyond = plane({-1.0, 50.0}, {1.0, 0.0}, 1e3);
  beyond.damage = 0.3;
  planes.push_back(beyond);
  CHECK(crack_of(planes).damaged_width == doctest::Approx(18.1).epsilon(1e-12));
}

TEST_CASE("damage on one side of the crack only makes no width on the other") {
  std::vector<CrackPlane> planes = row(10);
  for (CrackPlane& broken : planes) broken.spent_energy = 2.0;
  for (int i = 1; i <= 20; ++i) {
    planes.push_back(plane({i * 0.9, 1.0}, {1.0, 0.0}, 4.0));
    planes.back().damage = 0.5;
  }
  CHECK(crack_of(planes).damaged_width == doctest::Approx(1.0).epsilon(1e-12));
}

TEST_CASE("planes meet where they cross, or half-way between their closest points") {
  const CrackPlane level = plane({0.0, 0.0}, {1.0, 0.0});
  const Meeting crossing = meeting(level, plane({0.5, 0.25}, {0.0, 1.0}));
  CHECK(crossing.gap == 0.0);
  CHECK(norm(crossing.point - Vector{0.5, 0.0}) < 1e-15);
  const Meeting apart = meeting(level, plane({2.0, 1.4}, {0.0, 1.0}));
  CHECK(apart.gap == doctest::Approx(std::sqrt(1.0 + 0.16)));
  CHECK(norm(apart.point - Vector{1.5, 0.2}) < 1e-15);
  const Meeting parallel = meeting(level, plane({0.5, 1.0}, {1.0, 0.0}));
  CHECK(parallel.gap == doctest::Approx(1.0));
  CHECK(parallel.point.y == doctest::Approx(0.5));
}
