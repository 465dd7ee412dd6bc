#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/hexagonal.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/made_generator.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

std::unique_ptr<Generator> hexagonal(double radius, const std::string& lines = "shorter_side") {
  return made_generator("hexagonal", {{"radius", radius}, {"lines", lines}});
}

Packing fill(double width, double height, double radius, const std::string& lines = "shorter_side") {
  return hexagonal(radius, lines)->generate({{0.0, 0.0}, {width, height}}, 1);
}

double entry(const Packing& packing, const std::string& name) { return value_of(packing.report, name); }

/// Number of particles at each coordinate of an axis.
std::map<long, int> counts_by_line(const Packing& packing, int axis) {
  std::map<long, int> counts;
  for (const Vector& centre : packing.position) ++counts[std::lround(component(centre, axis) * 1e9)];
  return counts;
}

/// Pairs that touch, and what a lattice of lines of n and n - 1 has of them.
void check_all_neighbours_touch(const Packing& packing, int n_per_line, int n_lines) {
  const auto pairs = reference::all_particle_pairs(packing.position, packing.radius, 1e-9 * packing.radius[0]);
  const int n_long = (n_lines + 1) / 2;
  const int n_short = n_lines / 2;
  const int along = n_long * (n_per_line - 1) + n_short * (n_per_line - 2);
  const int across = (n_lines - 1) * 2 * (n_per_line - 1);
  CHECK(pairs.size() == static_cast<std::size_t>(along + across));
}

}  // namespace

TEST_CASE("the paper's assembly H1: 595 particles of 20 mm in 0.8 m x 1.0 m") {
  const Packing packing = fill(0.8, 1.0, 0.02);
  REQUIRE(packing.size() == 595);
  const auto rows = counts_by_line(packing, 1);
  REQUIRE(rows.size() == 29);
  int number = 0;
  for (const auto& [height, count] : rows) {
    CHECK(count == (number % 2 == 0 ? 21 : 20));
    CHECK(static_cast<double>(height) * 1e-9 == doctest::Approx(0.02 + number * 0.96 / 28).epsilon(1e-7));
    ++number;
  }
  CHECK(entry(packing, "pitch_m") == doctest::Approx(0.039).epsilon(1e-12));
  CHECK(entry(packing, "line_pitch_m") == doctest::Approx(0.96 / 28).epsilon(1e-12));
  check_all_neighbours_touch(packing, 21, 29);
}

TEST_CASE("the paper's assembly H2: 357 particles of 15 mm in 0.8 m x 0.34 m") {
  const Packing packing = fill(0.8, 0.34, 0.015);
  REQUIRE(packing.size() == 357);
  const auto columns = counts_by_line(packing, 0);
  CHECK(columns.size() == 31);
  CHECK(columns.begin()->second == 12);
  CHECK(std::next(columns.begin())->second == 11);
  check_all_neighbours_touch(packing, 12, 31);
}

TEST_CASE("lines along x fill the region of H2 with 13 rows of 28 and 27") {
  const Packing packing = fill(0.8, 0.34, 0.015, "x");
  CHECK(packing.size() == 7 * 28 + 6 * 27);
  const auto rows = counts_by_line(packing, 1);
  CHECK(rows.size() == 13);
  CHECK(rows.begin()->second == 28);
}

TEST_CASE("long lines end half a radius from the border, the first and last line touch it") {
  for (const auto& [width, height] : {std::pair{0.8, 1.0}, {1.0, 0.8}, {0.337, 0.29}, {0.3, 3.0}}) {
    const double radius = 0.02;
    const Packing packing = fill(width, height, radius);
    Vector low = packing.position[0];
    Vector high = low;
    for (const Vector& centre : packing.position) {
      low = {std::min(low.x, centre.x), std::min(low.y, centre.y)};
      high = {std::max(high.x, centre.x), std::max(high.y, centre.y)};
    }
    const bool along_x = width <= height;
    const double end = 0.5 * radius;
    CHECK((along_x ? low.x : low.y) == doctest::Approx(end).epsilon(1e-12));
    CHECK((along_x ? width - high.x : height - high.y) == doctest::Approx(end).epsilon(1e-12));
    CHECK((along_x ? low.y : low.x) == doctest::Approx(radius).epsilon(1e-12));
    CHECK((along_x ? height - high.y : width - high.x) == doctest::Approx(radius).epsilon(1e-12));
  }
}

TEST_CASE("neighbours touch and are nowhere squeezed by more than a tenth, whatever the region") {
  for (int i = 0; i < 40; ++i) {
    const double width = 0.3 + 0.013 * i;
    const double height = 0.9 - 0.0117 * i;
    CAPTURE(width);
    CAPTURE(height);
    const Packing packing = fill(width, height, 0.02, "x");
    const auto rows = counts_by_line(packing, 1);
    check_all_neighbours_touch(packing, rows.begin()->second, static_cast<int>(rows.size()));
    CHECK(entry(packing, "pitch_m") > 0.9 * 0.04);
    const double oblique = std::hypot(0.5 * entry(packing, "pitch_m"), entry(packing, "line_pitch_m"));
    CHECK(oblique > 0.9 * 0.04);
    CHECK(oblique <= 0.04);
  }
}

TEST_CASE("a region elsewhere is filled in the same way") {
  const Packing here = fill(0.8, 1.0, 0.02);
  const Packing there = hexagonal(0.02)->generate({{1.6, -3.0}, {2.4, -2.0}}, 7);
  REQUIRE(there.size() == here.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    CHECK(norm(there.position[i] - here.position[i] - Vector{1.6, -3.0}) < 1e-14);
  }
}

TEST_CASE("a region too small for a lattice is refused in words") {
  CHECK_THROWS_WITH_AS(fill(0.05, 1.0, 0.02), doctest::Contains("0.02"), InputError);
  CHECK_THROWS_AS(fill(1.0, 0.05, 0.02, "x"), InputError);
  CHECK_THROWS_AS(fill(0.0, 1.0, 0.02), InputError);
  CHECK_NOTHROW(fill(0.06, 0.08, 0.02));
}

TEST_CASE("the report counts what is there") {
  const Packing packing = fill(0.8, 1.0, 0.02);
  CHECK(entry(packing, "n_particles") == 595.0);
  CHECK(entry(packing, "smallest_radius_m") == 0.02);
  CHECK(entry(packing, "mean_radius_m") == doctest::Approx(0.02).epsilon(1e-12));
  CHECK(entry(packing, "largest_radius_m") == 0.02);
  CHECK(entry(packing, "area_ratio") == doctest::Approx(595 * 3.14159265358979 * 4e-4 / 0.8).epsilon(1e-12));
}

TEST_CASE("the radius must be given and positive and lines know three words") {
  const Hexagonal defaults;
  CHECK(defaults.default_interface_gap() == 0.5);
  auto generator = generators().create("hexagonal");
  Parameters parameters;
  generator->declare(parameters);
  CHECK(parameters.find("radius")->required);
  CHECK(parameters.find("radius")->complaint(0.0).has_value());
  CHECK(parameters.find("lines")->complaint("z").has_value());
  CHECK_FALSE(parameters.find("lines")->complaint("y").has_value());
  CHECK_THROWS_WITH_AS(generators().create("hexagon"), doctest::Contains("hexagonal"), InputError);
}
