#include <doctest/doctest.h>

#include <numeric>

#include "support/element_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

StructuredMesh skewed_mesh() {
  const GridLines lines{even_lines(0.0, 3.0, 5), even_lines(0.0, 2.0, 4)};
  return mapped(build_structured_mesh(lines, {{{0.6, 0.5}, {1.2, 1.0}}}), [](const Vector& p) {
    return Vector{p.x + 0.3 * p.y * p.x, p.y + 0.1 * p.x};
  });
}

}  // namespace

TEST_CASE("the masses of the nodes add up to ρ A t") {
  const Model model = element_model(skewed_mesh(), {.density = 2400.0, .thickness = 0.3});
  double area = 0.0;
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const QuadrilateralCorners corners = corners_of(model, element);
    area += 0.5 * cross(corners[2] - corners[0], corners[3] - corners[1]);
  }
  const double mass = std::accumulate(model.nodes.real_mass.begin(), model.nodes.real_mass.end(), 0.0);
  CHECK(mass == doctest::Approx(2400.0 * area * 0.3).epsilon(1e-13));
  for (const double node_mass : model.nodes.real_mass) CHECK(node_mass > 0.0);
}

TEST_CASE("a linear field has the same stress in all elements") {
  const Model model =
      element_model(skewed_mesh(), {.young_modulus = 2.0, .poisson_ratio = 0.3, .plane = PlaneState::strain});
  Field<Vector> displacement;
  for (const Vector& p : model.nodes.position)
    displacement.push_back({1.0 + 0.1 * p.x + 0.2 * p.y, 0.3 * p.x - 0.4 * p.y});
  const PlaneTensor stress = stress_of(elasticity_matrix(2.0, 0.3, PlaneState::strain), {0.1, -0.4, 0.5});
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const ElementStress found = element_stress(model, displacement, element);
    for (std::size_t i = 0; i < 3; ++i) CHECK(found.stress[i] == doctest::Approx(stress[i]).epsilon(1e-12));
    CHECK(found.strain[2] == doctest::Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("each element has the stiffness of its own material") {
  Model model = element_model(build_structured_mesh({{0.0, 1.0, 2.0}, {0.0, 1.0}}, {}), {.density = 1.0});
  model.materials.push_back(model.materials.front());
  model.materials.back().young_modulus = 5.0;
  model.materials.back().density = 3.0;
  model.elements.material[1] = 1;
  fill_element_properties(model);
  for (std::size_t k = 0; k < 64; ++k) {
    CHECK(model.elements.stiffness[1][k] == doctest::Approx(5.0 * model.elements.stiffness[0][k]));
  }
  CHECK(model.nodes.real_mass[0] == doctest::Approx(0.25));
  CHECK(model.nodes.real_mass[1] == doctest::Approx(1.0));
  CHECK(model.nodes.real_mass[2] == doctest::Approx(0.75));
}
