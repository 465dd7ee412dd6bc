#include <doctest/doctest.h>

#include <cmath>

#include "mesh/element_forces.hpp"
#include "support/element_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

Model skewed_model() {
  const GridLines lines{even_lines(0.0, 3.0, 4), even_lines(0.0, 2.0, 3)};
  return element_model(mapped(build_structured_mesh(lines, {}),
                              [](const Vector& p) {
                                return Vector{p.x + 0.2 * p.y * p.x, p.y + 0.1 * p.x};
                              }),
                       {.young_modulus = 2.0, .poisson_ratio = 0.3});
}

/// Displaces all nodes by a field of the position and lets the elements answer.
template <class Displace>
State displaced(const Model& model, Displace&& displace) {
  State state = resting_state(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.nodes.translation.displacement[i] = displace(model.nodes.position[i]);
  }
  ElementForces().add_forces(model, state);
  return state;
}

double largest_force(const State& state) {
  double largest = 0.0;
  for (const Vector& force : state.nodes.translation.force) largest = std::max(largest, norm(force));
  return largest;
}

}  // namespace

TEST_CASE("rigid translations and rotation of a mesh make no force") {
  const Model model = skewed_model();
  CHECK(largest_force(displaced(model, [](const Vector&) { return Vector{1.0, 0.0}; })) < 1e-14);
  CHECK(largest_force(displaced(model, [](const Vector&) { return Vector{0.0, 1.0}; })) < 1e-14);
  CHECK(largest_force(displaced(model, [](const Vector& p) { return cross(1.0, p); })) < 1e-14);
}

TEST_CASE("forces of elements balance and are the slope of their energy") {
  const Model model = skewed_model();
  const auto bent = [](const Vector& p) { return Vector{0.1 * p.x * p.y, std::sin(p.x) - 0.2 * p.y}; };
  const State state = displaced(model, bent);
  Vector sum;
  Moment moment = 0.0;
  double work = 0.0;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    sum += state.nodes.translation.force[i];
    moment += cross(model.nodes.position[i], state.nodes.translation.force[i]);
    work -= 0.5 * dot(state.nodes.translation.force[i], state.nodes.translation.displacement[i]);
  }
  CHECK(norm(sum) < 1e-14);
  CHECK(std::abs(moment) < 1e-14);
  const auto energies = ElementForces().energies(model, state);
  REQUIRE(energies.size() == 1);
  CHECK(energies[0].kind == EnergyKind::elastic);
  CHECK(energies[0].value == doctest::Approx(work).epsilon(1e-14));
}

TEST_CASE("forces are added to those of others") {
  const Model model = skewed_model();
  State state = resting_state(model);
  state.nodes.translation.force[3] = {7.0, -8.0};
  ElementForces().add_forces(model, state);
  CHECK(state.nodes.translation.force[3] == Vector{7.0, -8.0});
}

TEST_CASE("the bound of one square: the larger of the row sums of each node") {
  const double nu = 0.2;
  const Model model = element_model(build_structured_mesh({{0.0, 1.0}, {0.0, 1.0}}, {}), {.poisson_ratio = nu});
  StiffnessBounds bounds(0, model.nodes.size());
  ElementForces().add_stiffness(model, resting_state(model), bounds);
  const double row = (0.5 - nu / 6.0) + (0.25 + nu / 12.0) + (0.25 - nu / 12.0) + nu / 6.0 + 2.0 * (0.125 + nu / 8.0) +
                     2.0 * std::abs(-0.125 + 3.0 * nu / 8.0);
  for (const double bound : bounds.node_translation) {
    CHECK(bound == doctest::Approx(row / (1.0 - nu * nu)).epsilon(1e-14));
  }
}

TEST_CASE("where there are no particles, the forces of elements are the measure of unbalanced ones") {
  Model model = element_model(build_structured_mesh({{0.0, 1.0}, {0.0, 1.0}}, {}), {});
  // Uniaxial stress 1: every node carries half a unit of force.
  const State state = displaced(model, [](const Vector& p) { return Vector{p.x, 0.0}; });
  const ForceMagnitudes magnitudes = ElementForces().internal_forces(model, state);
  CHECK(magnitudes.sum == doctest::Approx(2.0));
  CHECK(magnitudes.count == 4.0);

  model.particles.radius.push_back(1.0);
  CHECK(ElementForces().internal_forces(model, state).count == 0.0);
}
