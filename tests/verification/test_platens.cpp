#include <doctest/doctest.h>

#include <cmath>

#include "integrator/platens.hpp"
#include "integrator/two_level_relaxation.hpp"
#include "mesh/beam_properties.hpp"
#include "mesh/element_properties.hpp"
#include "support/energy_drift.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/meshed_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.005;
constexpr double load = 1e5;

/// A platen above what is below it, which it touches; hinged to a node of a beam where one is given.
void add_platen(Model& model, const Vector& middle, double width, Index hinge = -1) {
  const Vector half{0.5 * width, 0.0};
  // Walls face what is on the right of their way.
  const std::size_t wall = add_wall(model, middle - half, middle + half);
  for (const Index node : model.wall_nodes(wall)) model.nodes.free[node] = Vector{};
  const Index own = add_beam_node(middle, 0.5 * width, 0, model.beam_nodes);
  model.beam_nodes.real_mass[own] = 0.1;
  model.beam_nodes.real_inertia[own] = 0.1 * width * width / 12.0;
  if (hinge >= 0) model.beam_nodes.free[own] = Vector{};
  model.platens.push_back({static_cast<Index>(wall), hinge >= 0 ? hinge : own, own});
}

/// Two held discs side by side, their tops at a place.
void add_pair(Model& model, const Vector& top, std::vector<PrescribedFreedom>& prescribed) {
  for (const double side : {-1.0, 1.0}) {
    const Index row = add_particle(model, top + Vector{2.0 * side * radius, -radius}, radius);
    for (const PrescribedFreedom& freedom : held_particle(row)) prescribed.push_back(freedom);
  }
}

/// A steel beam on two platens on discs, loaded in between at its node 1.
struct BeamOnPlatens {
  Model model = empty_model({.young_modulus = 20e9, .interface_gap = 1e-6});
  SimulationChoice choice;

  explicit BeamOnPlatens(double stiffness_factor = 1.0) {
    const BeamSection section{.young_modulus = stiffness_factor * 210e9,
                              .poisson_ratio = 0.3,
                              .density = 7850.0,
                              .depth = 0.155,
                              .width = 0.051,
                              .theory = BeamTheory::timoshenko};
    add_beam("steel", {{-0.458, 0.0}, {0.0, 0.0}, {0.061, 0.0}}, section, model);
    for (const Index node : {0, 2}) {
      const Vector place = model.beam_nodes.position[node];
      add_pair(model, place, choice.prescribed);
      add_platen(model, place, 0.03, node);
    }
    choice.prescribed.push_back({.body = BodyTable::beam_node, .row = 1, .axis = 0});
    choice.loads = {{.body = BodyTable::beam_node, .row = 1, .force = {0.0, -load}}};
  }

  /// Loaded so slowly that no platen is thrown off.
  void relax() {
    choice.loads.front().rise_time = 1000.0;
    choice.time_step = {.masses = Masses::scaled};
    choice.integrator = std::make_unique<TwoLevelRelaxation>();
  }
};

/// What a platen carries (N).
Vector carried(const Simulation& simulation, std::size_t platen) {
  return simulation.state().platens.force[2 * platen] + simulation.state().platens.force[2 * platen + 1];
}

}  // namespace

TEST_CASE("the load on a beam goes to its platens by the law of the lever whatever its stiffness" *
          doctest::test_suite("slow")) {
  for (const double factor : {1.0, 10.0}) {
    BeamOnPlatens beam(factor);
    beam.relax();
    Simulation simulation = make_simulation(std::move(beam.model), std::move(beam.choice));
    for (int step = 0; step < 3000; ++step) simulation.step();
    CHECK(carried(simulation, 0).y == doctest::Approx(load * 61.0 / 519.0).epsilon(1e-6));
    CHECK(carried(simulation, 1).y == doctest::Approx(load * 458.0 / 519.0).epsilon(1e-6));
    CHECK(simulation.audit() < 1e-6);
    // The ends are where their middle puts them, and say what it gives them.
    const Platen& platen = simulation.model().platens[1];
    const auto ends = simulation.model().wall_nodes(1);
    const Field<Vector>& displacement = simulation.state().nodes.translation.displacement;
    const Vector middle = simulation.state().beam_nodes.translation.displacement[platen.translation];
    CHECK(norm(0.5 * (displacement[ends[0]] + displacement[ends[1]]) - middle) < 1e-12 * norm(middle));
    CHECK(holding_force(simulation.model(), simulation.state(), ends[0]) == -simulation.state().platens.force[2]);
  }
}

TEST_CASE("a beam that is dropped on its platens swings and keeps its energy") {
  BeamOnPlatens beam;
  Simulation simulation = make_simulation(std::move(beam.model), std::move(beam.choice));
  for (int step = 0; step < 5000; ++step) {
    simulation.step();
    CHECK(simulation.audit() < 1e-4);
  }
  CHECK(energy(simulation, "elastic_beams") > 0.0);
  CHECK(carried(simulation, 1).y > 0.0);
}

TEST_CASE("a platen that is pushed beside its middle turns until both sides carry their share") {
  std::vector<PrescribedFreedom> prescribed;
  Model model = empty_model({.young_modulus = 20e9, .interface_gap = 1e-6});
  add_pair(model, {0.0, 0.0}, prescribed);
  add_platen(model, {0.0, 0.0}, 0.03);
  prescribed.push_back({.body = BodyTable::beam_node, .row = 0, .axis = 0});
  SimulationChoice choice;
  choice.prescribed = prescribed;
  // A force 2.5 mm to the right of the middle.
  choice.loads = {{.body = BodyTable::beam_node, .row = 0, .force = {0.0, -load}, .moment = -0.0025 * load}};
  choice.time_step = {.masses = Masses::scaled};
  choice.integrator = std::make_unique<TwoLevelRelaxation>();
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  for (int step = 0; step < 2000; ++step) simulation.step();
  const ContactTable& contacts = simulation.state().facet_contacts;
  REQUIRE(contacts.size() == 2);
  CHECK(contacts.normal_force[0] == doctest::Approx(0.375 * load).epsilon(1e-4));
  CHECK(contacts.normal_force[1] == doctest::Approx(0.625 * load).epsilon(1e-4));
  CHECK(simulation.state().beam_nodes.rotation.rotation[0] < 0.0);
}
