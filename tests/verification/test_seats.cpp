#include <doctest/doctest.h>

#include <numeric>

#include "contact/contact_stiffness.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/meshed_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A block of two elements, 0.2 by 0.1 m, its bottom on a wall, its top moved.
Simulation block_on_wall(const WallChoice& wall, const Vector& velocity, const Vector& velocity_of_wall = {}) {
  Model model = empty_model({.young_modulus = 20e9});
  add_mesh(model, {even_lines(0.0, 0.2, 2), even_lines(0.0, 0.1, 1)});
  add_wall(model, {0.3, 0.0}, {-0.1, 0.0}, wall);
  SimulationChoice choice;
  choice.time_step = {.masses = Masses::scaled};
  choice.prescribed = moved_wall(model, 0, velocity_of_wall);
  for (Index node = 0; node < static_cast<Index>(model.n_mesh_nodes()); ++node) {
    if (component(model.nodes.position[node], 1) == 0.0) continue;
    for (int axis = 0; axis < dimension; ++axis) {
      choice.prescribed.push_back({.row = node, .axis = axis, .motions = {{.velocity = component(velocity, axis)}}});
    }
  }
  return make_simulation(std::move(model), std::move(choice));
}

double sum(const Field<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("nodes of elements stand on a wall, as stiff as particles of what they hold of the edge") {
  const Simulation simulation = block_on_wall({}, {});
  const ContactTable& seats = simulation.state().seat_contacts;
  REQUIRE(seats.size() == 3);
  CHECK(sum(seats.area) == doctest::Approx(0.2 * simulation.model().thickness));
  const Material& material = simulation.model().materials[0];
  const ContactStiffness like =
      contact_stiffness(material, PlaneState::stress, 0.1, 0.05, simulation.model().thickness);
  for (const double stiffness : seats.normal_stiffness) CHECK(stiffness == doctest::Approx(like.normal));
  for (const double stiffness : seats.shear_stiffness) CHECK(stiffness == doctest::Approx(like.shear));
}

TEST_CASE("elements press on a wall and come off it, unless ties hold them") {
  for (const bool is_tied : {false, true}) {
    for (const double direction : {-1.0, 1.0}) {
      Simulation simulation = block_on_wall({.is_tied = is_tied}, {0.0, direction * 1e-8});
      for (int step = 0; step < 200; ++step) {
        simulation.step();
        CHECK(simulation.audit() < 1e-8);
      }
      const double pressed = sum(simulation.state().seat_contacts.normal_force);
      CHECK((direction < 0.0 || is_tied ? -direction * pressed > 0.0 : pressed == 0.0));
    }
  }
}

TEST_CASE("a wall that is drawn along under pressed elements rubs with μ times the pressure") {
  constexpr double friction = 0.3;
  Simulation simulation = block_on_wall({.friction_coefficient = friction}, {0.0, -1e-8}, {1e-8, 0.0});
  for (int step = 0; step < 2000; ++step) simulation.step();
  const ContactTable& seats = simulation.state().seat_contacts;
  for (std::size_t row = 0; row < seats.size(); ++row) {
    CHECK(std::abs(seats.shear_force[row]) == doctest::Approx(friction * seats.normal_force[row]).epsilon(1e-9));
  }
  CHECK(simulation.audit() < 1e-3);
  CHECK(energy(simulation, "friction") > 0.0);
}
