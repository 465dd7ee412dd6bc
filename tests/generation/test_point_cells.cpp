#include <doctest/doctest.h>

#include "generation/point_cells.hpp"
#include "generation/random_numbers.hpp"

using namespace ligament;

TEST_CASE("points nearer than a cell are found, whenever they came") {
  const Vector size{1.3, 0.7};
  constexpr double reach = 0.08;
  PointCells cells(size, reach);
  RandomNumbers random(3);
  int n_found = 0;
  for (int i = 0; i < 400; ++i) {
    const double x = random.uniform(0.0, size.x);
    const Vector place{x, random.uniform(0.0, size.y)};
    const auto is_near = [&](const Vector& point) { return norm(point - place) < reach; };
    const bool found = cells.any_near(place, [&](Index point) { return is_near(cells.points()[point]); });
    CHECK(found == std::any_of(cells.points().begin(), cells.points().end(), is_near));
    n_found += found ? 1 : 0;
    cells.add(place);
  }
  CHECK(n_found > 200);
  CHECK(n_found < 399);
  CHECK(cells.points().size() == 400);
}

TEST_CASE("a box smaller than a cell is one cell") {
  PointCells cells({0.1, 0.2}, 1.0);
  CHECK_FALSE(cells.any_near({0.0, 0.0}, [](Index) { return true; }));
  cells.add({0.1, 0.2});
  CHECK(cells.any_near({0.0, 0.0}, [](Index) { return true; }));
}
