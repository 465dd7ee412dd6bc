#include <doctest/doctest.h>

#include <cmath>

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "reference/direct_solution.hpp"
#include "support/hand_made_model.hpp"
#include "support/meshed_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

State bonded_state(Model& model) {
  State state = resting_state(model);
  GridContactDetector(1e-6).bond(model, state);
  return state;
}

}  // namespace

TEST_CASE("the direct solution of a bar of elements is F L / (E A)") {
  constexpr double force = 1e4;
  Model model = empty_model({.young_modulus = 20e9, .poisson_ratio = 0.2, .thickness = 0.5});
  add_mesh(model, {even_lines(0.0, 4.0, 8), even_lines(0.0, 1.0, 2)});
  Field<Vector> loads(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Vector& place = model.nodes.position[i];
    if (place.x == 0.0) model.nodes.free[i] = {0.0, place.y == 0.0 ? 0.0 : 1.0};
    if (place.x == 4.0) loads[i] = {place.y == 0.5 ? 0.5 * force : 0.25 * force, 0.0};
  }
  const State state = bonded_state(model);
  const auto solution = reference::solve_directly(model, state, loads);
  const double stress = force / (1.0 * model.thickness);
  Vector reaction;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Vector& place = model.nodes.position[i];
    CHECK(solution.node_displacement[i].x == doctest::Approx(stress / 20e9 * place.x).epsilon(1e-10).scale(1e-6));
    CHECK(solution.node_displacement[i].y ==
          doctest::Approx(-0.2 * stress / 20e9 * place.y).epsilon(1e-10).scale(1e-6));
    reaction += solution.node_reaction[i];
  }
  CHECK(reaction.x == doctest::Approx(-force).epsilon(1e-10));
  CHECK(std::abs(reaction.y) < 1e-9 * force);
}

TEST_CASE("the direct solution of a chain of discs is that of springs in series") {
  Model model = empty_model();
  constexpr int n_links = 5;
  constexpr double radius = 0.1;
  for (int i = 0; i <= n_links; ++i) add_particle(model, {2.0 * radius * i, 0.0}, radius);
  for (Vector& free : model.particles.free) free = {1.0, 0.0};
  for (double& free : model.particles.rotation_free) free = 0.0;
  model.particles.free[0] = {0.0, 0.0};
  const State state = bonded_state(model);
  REQUIRE(state.particle_contacts.size() == n_links);
  const double k_n = state.particle_contacts.normal_stiffness[0];

  reference::FreedomValues loads(model);
  loads.particle[n_links] = {3.0, 0.0};
  SUBCASE("stretched") {
    const auto solution = reference::solve_directly(model, state, loads, reference::FreedomValues(model));
    for (int i = 0; i <= n_links; ++i) {
      CHECK(solution.particle_displacement[i].x == doctest::Approx(3.0 * i / k_n).epsilon(1e-12));
    }
    CHECK(solution.particle_reaction[0].x == doctest::Approx(-3.0).epsilon(1e-12));
  }
  SUBCASE("an end displacement instead of a force") {
    model.particles.free[n_links] = {0.0, 0.0};
    reference::FreedomValues prescribed(model);
    prescribed.particle[n_links] = {3.0 * n_links / k_n, 0.0};
    const auto solution = reference::solve_directly(model, state, reference::FreedomValues(model), prescribed);
    CHECK(solution.particle_reaction[n_links].x == doctest::Approx(3.0).epsilon(1e-12));
    CHECK(solution.particle_displacement[2].x == doctest::Approx(6.0 / k_n).epsilon(1e-12));
  }
  SUBCASE("a chain that may turn as a whole is a mechanism") {
    model.particles.free[0] = {1.0, 1.0};
    CHECK_THROWS(reference::solve_directly(model, state, loads, reference::FreedomValues(model)));
  }
}

TEST_CASE("the direct solution holds a disc between two walls by its interface springs") {
  constexpr double radius = 0.02;
  constexpr double gap = 0.5 * radius;
  Model model = empty_model();
  // The solid lies left of a facet: the left wall runs up, the right one down.
  for (const Vector& place : {Vector{0.0, -1.0}, {0.0, 1.0}, {2.0 * gap, 1.0}, {2.0 * gap, -1.0}}) {
    add_node(model, place);
  }
  add_facet(model, 0, 1);
  add_facet(model, 2, 3);
  for (Vector& free : model.nodes.free) free = {0.0, 0.0};
  add_particle(model, {gap, 0.25}, radius);
  const State state = bonded_state(model);
  REQUIRE(state.facet_contacts.size() == 2);

  reference::FreedomValues loads(model);
  loads.particle[0] = {3.0, 5.0};
  loads.rotation[0] = 7.0;
  const auto solution = reference::solve_directly(model, state, loads, reference::FreedomValues(model));
  // Eq. (33) with H = 2 R and L = R/2.
  const double k_n = 4.0 * 1e9 / (1.0 - 0.04);
  const double k_s = 4.0 * 1e9 / 2.4;
  CHECK(solution.particle_displacement[0].x == doctest::Approx(3.0 / (2.0 * k_n)).epsilon(1e-12));
  CHECK(solution.particle_displacement[0].y == doctest::Approx(5.0 / (2.0 * k_s)).epsilon(1e-12));
  CHECK(solution.particle_rotation[0] == doctest::Approx(7.0 / (2.0 * k_s * gap * gap)).epsilon(1e-12));
  // Each wall takes half of the force, shared by its nodes as the lever asks.
  CHECK(solution.node_reaction[0].x == doctest::Approx(-1.5 * 0.375).epsilon(1e-12));
  CHECK(solution.node_reaction[1].x == doctest::Approx(-1.5 * 0.625).epsilon(1e-12));
  CHECK(solution.node_reaction[2].x == doctest::Approx(-1.5 * 0.625).epsilon(1e-12));
}
