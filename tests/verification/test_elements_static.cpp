#include <doctest/doctest.h>

#include <cmath>

#include "reference/direct_solution.hpp"
#include "support/element_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;
using reference::DirectSolution;
using reference::FreedomValues;
using reference::solve_directly;

namespace {

DirectSolution solved(const Model& model, const Field<Vector>& node_loads) {
  return solve_directly(model, resting_state(model), node_loads);
}

/// The patch of MacNeal and Harder: four nodes out of line inside a rectangle of 0.24 × 0.12.
Model patch() {
  StructuredMesh mesh;
  mesh.nodes.position = {{0.0, 0.0},   {0.24, 0.0},  {0.24, 0.12}, {0.0, 0.12},
                         {0.04, 0.02}, {0.18, 0.03}, {0.16, 0.08}, {0.08, 0.08}};
  mesh.nodes.free.assign(8, uniform_vector(1.0));
  for (std::size_t corner = 0; corner < 4; ++corner) mesh.nodes.free[corner] = {};
  mesh.nodes.id = {1, 2, 3, 4, 5, 6, 7, 8};
  mesh.elements.nodes = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  mesh.elements.id = {1, 2, 3, 4, 5};
  return element_model(std::move(mesh), {.young_modulus = 1e6, .poisson_ratio = 0.25, .thickness = 0.001});
}

Vector patch_displacement(const Vector& p) { return {1e-3 * (p.x + 0.5 * p.y), 1e-3 * (p.y + 0.5 * p.x)}; }

/// Cook's skew membrane, n × n elements, held at the left and sheared at the right.
double deflection_of_cooks_membrane(int n) {
  const GridLines lines{even_lines(0.0, 1.0, n), even_lines(0.0, 1.0, n)};
  const auto place = [](const Vector& p) { return Vector{48.0 * p.x, 44.0 * p.x + p.y * (44.0 - 28.0 * p.x)}; };
  Model model = element_model(mapped(build_structured_mesh(lines, {}), place),
                              {.young_modulus = 1.0, .poisson_ratio = 1.0 / 3.0});
  Field<Vector> loads(model.nodes.size());
  const int n_row = n + 1;
  for (int row = 0; row <= n; ++row) {
    model.nodes.free[row * n_row] = {};
    const double share = (row == 0 || row == n ? 0.5 : 1.0) / n;
    loads[row * n_row + n] = {0.0, share};
  }
  return solved(model, loads).node_displacement[(n / 2) * n_row + n].y;
}

/// The tensioned column: 6 × 3 elements, held at the left, pulled at the right.
Model tensioned_column() {
  Model model = element_model(build_structured_mesh({even_lines(0.0, 4.8, 6), {0.0, 0.33, 0.67, 1.0}}, {}),
                              {.young_modulus = 20e9, .poisson_ratio = 0.2});
  for (const Index node : {0, 7, 14, 21}) model.nodes.free[node] = {0.0, 1.0};
  model.nodes.free[0] = {};
  return model;
}

/// An error of at most half a unit of the last digit printed.
bool agrees(double value, double printed, double last_digit) { return std::abs(value - printed) <= 0.5 * last_digit; }

}  // namespace

TEST_CASE("patch test: a linear field is solved exactly on distorted elements") {
  const Model model = patch();
  FreedomValues prescribed(model);
  for (std::size_t i = 0; i < 4; ++i) prescribed.node[i] = patch_displacement(model.nodes.position[i]);
  const DirectSolution solution = solve_directly(model, resting_state(model), FreedomValues(model), prescribed);
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(norm(solution.node_displacement[i] - patch_displacement(model.nodes.position[i])) < 1e-17);
  }
  for (std::size_t element = 0; element < 5; ++element) {
    const PlaneTensor stress = element_stress(model, solution.node_displacement, element).stress;
    CHECK(stress[0] == doctest::Approx(4000.0 / 3.0).epsilon(1e-12));
    CHECK(stress[1] == doctest::Approx(4000.0 / 3.0).epsilon(1e-12));
    CHECK(stress[2] == doctest::Approx(400.0).epsilon(1e-12));
  }
}

TEST_CASE("Cook's membrane: the deflections that are known of this element") {
  CHECK(agrees(deflection_of_cooks_membrane(2), 11.85, 0.01));
  CHECK(agrees(deflection_of_cooks_membrane(4), 18.30, 0.01));
  CHECK(agrees(deflection_of_cooks_membrane(8), 22.08, 0.01));
  CHECK(agrees(deflection_of_cooks_membrane(16), 23.43, 0.01));
}

TEST_CASE("tensioned column by finite elements alone: all numbers of the paper's Table 2") {
  const Model model = tensioned_column();
  Field<Vector> loads(model.nodes.size());
  loads[6] = loads[27] = {1670.0, 0.0};
  loads[13] = loads[20] = {3330.0, 0.0};
  const DirectSolution solution = solved(model, loads);
  const double micrometre = 1e-6;
  CHECK(agrees(solution.node_displacement[6].x, 2.402 * micrometre, 0.001 * micrometre));
  CHECK(agrees(solution.node_displacement[13].x, 2.399 * micrometre, 0.001 * micrometre));
  CHECK(agrees(solution.node_displacement[20].x, 2.399 * micrometre, 0.001 * micrometre));
  CHECK(agrees(solution.node_displacement[27].x, 2.402 * micrometre, 0.001 * micrometre));
  CHECK(agrees(solution.node_reaction[0].x, -1650.0, 1.0));
  CHECK(agrees(solution.node_reaction[7].x, -3350.0, 1.0));
  CHECK(agrees(solution.node_reaction[14].x, -3350.0, 1.0));
  CHECK(agrees(solution.node_reaction[21].x, -1650.0, 1.0));
}
