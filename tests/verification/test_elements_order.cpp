#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "reference/direct_solution.hpp"
#include "support/element_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double poisson_ratio = 0.3;

/// The unit square in elements that are all of different shape.
Model distorted_square(int n) {
  const GridLines lines{even_lines(0.0, 1.0, n), even_lines(0.0, 1.0, n)};
  const auto place = [](const Vector& p) {
    const double swell = 0.05 * std::sin(2.0 * pi * p.x) * std::sin(2.0 * pi * p.y);
    return Vector{p.x + swell, p.y - swell};
  };
  Model model = element_model(mapped(build_structured_mesh(lines, {}), place), {.poisson_ratio = poisson_ratio});
  for (const auto& [i, j] : model.facets.nodes) model.nodes.free[i] = model.nodes.free[j] = {};
  return model;
}

/// u_x = sin πx sin πy, u_y = 0: zero on the border.
Vector exact_displacement(const Vector& p) { return {std::sin(pi * p.x) * std::sin(pi * p.y), 0.0}; }

/// The force per volume -div σ that makes it.
Vector body_force(const Vector& p) {
  const double plane = 1.0 / (1.0 - poisson_ratio * poisson_ratio);
  const double shear = 1.0 / (2.0 * (1.0 + poisson_ratio));
  return {pi * pi * (plane + shear) * std::sin(pi * p.x) * std::sin(pi * p.y),
          -pi * pi * (poisson_ratio * plane + shear) * std::cos(pi * p.x) * std::cos(pi * p.y)};
}

/// Root of the mean square over the area.
double error_on_mesh(int n) {
  const Model model = distorted_square(n);
  // Unit density and thickness: the lumped masses are the areas of the nodes.
  const Field<double>& area = model.nodes.real_mass;
  Field<Vector> loads;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) loads.push_back(area[i] * body_force(model.nodes.position[i]));
  const auto solution = reference::solve_directly(model, resting_state(model), loads);
  double square = 0.0;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Vector error = solution.node_displacement[i] - exact_displacement(model.nodes.position[i]);
    square += area[i] * dot(error, error);
  }
  return std::sqrt(square);
}

}  // namespace

TEST_CASE("displacements converge with the square of the element size") {
  double coarse = error_on_mesh(8);
  for (const int n : {16, 32}) {
    const double fine = error_on_mesh(n);
    const double order = std::log2(coarse / fine);
    CHECK(order > 1.9);
    CHECK(order < 2.2);
    coarse = fine;
  }
  CHECK(coarse < 2e-3);
}
