#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "integrator/two_level_relaxation.hpp"
#include "mesh/beam_properties.hpp"
#include "support/energy_drift.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double length = 2.0;

BeamSection steel(BeamTheory theory) {
  return {
      .young_modulus = 210e9, .poisson_ratio = 0.3, .density = 7850.0, .depth = 0.1, .width = 0.05, .theory = theory};
}

double bending_stiffness() {
  const BeamSection section = steel(BeamTheory::timoshenko);
  return section.young_modulus * section.second_moment();
}

/// A beam at an angle to x, its axis given by a unit vector.
Model beam_model(int n_elements, BeamTheory theory, const Vector& axis = {1.0, 0.0}) {
  Model model;
  std::vector<Vector> places;
  for (int i = 0; i <= n_elements; ++i) places.push_back((length * i / n_elements) * axis);
  add_beam("beam", places, steel(theory), model);
  return model;
}

std::vector<PrescribedFreedom> held(Index row, std::vector<int> axes) {
  std::vector<PrescribedFreedom> freedoms;
  for (const int axis : axes) freedoms.push_back({.body = BodyTable::beam_node, .row = row, .axis = axis});
  return freedoms;
}

/// Sets displacements and rotations as if they had been so before.
template <class Displacement, class Rotate>
void deform(Simulation& simulation, Displacement&& displacement, Rotate&& rotation) {
  State state = simulation.state();
  for (std::size_t i = 0; i < simulation.model().beam_nodes.size(); ++i) {
    const Vector& place = simulation.model().beam_nodes.position[i];
    state.beam_nodes.translation.displacement[i] = displacement(place);
    state.beam_nodes.rotation.rotation[i] = rotation(place);
  }
  simulation.restore(std::move(state));
}

}  // namespace

TEST_CASE("a clamped beam under a load at its tip deflects by P L³/3EI, and by P L / G A_s more if it shears") {
  constexpr double load = 1000.0;
  for (const BeamTheory theory : {BeamTheory::euler_bernoulli, BeamTheory::timoshenko}) {
    for (const Vector& axis : {Vector{1.0, 0.0}, Vector{0.6, 0.8}}) {
      Model model = beam_model(3, theory, axis);
      SimulationChoice choice;
      choice.prescribed = held(0, {0, 1, 2});
      choice.loads = {{.body = BodyTable::beam_node, .row = 3, .force = load * tangent(axis)}};
      choice.time_step = {.masses = Masses::scaled};
      choice.integrator = std::make_unique<TwoLevelRelaxation>();
      Simulation simulation = make_simulation(std::move(model), std::move(choice));
      for (int step = 0; step < 400; ++step) simulation.step();
      const double shear = theory == BeamTheory::timoshenko ? load * length / steel(theory).shear_rigidity() : 0.0;
      const double deflection = load * std::pow(length, 3) / (3.0 * bending_stiffness()) + shear;
      CHECK(dot(tangent(axis), simulation.state().beam_nodes.translation.displacement[3]) ==
            doctest::Approx(deflection).epsilon(1e-9));
      CHECK(simulation.state().beam_nodes.rotation.rotation[3] ==
            doctest::Approx(load * length * length / (2.0 * bending_stiffness())).epsilon(1e-9));
      CHECK(energy(simulation, "elastic_beams") == doctest::Approx(0.5 * load * deflection).epsilon(1e-9));
      CHECK(simulation.audit() < 1e-9);
    }
  }
}

TEST_CASE("rigid motion of a beam makes neither force nor energy") {
  Simulation simulation = make_simulation(beam_model(4, BeamTheory::timoshenko, {0.6, 0.8}));
  constexpr double turn = 1e-3;
  deform(
      simulation,
      [](const Vector& place) {
        return Vector{0.3, -0.7} + cross(Rotation{turn}, place);
      },
      [](const Vector&) { return turn; });
  const double energy_of_turn = bending_stiffness() / length * turn * turn;
  CHECK(std::abs(energy(simulation, "elastic_beams")) < 1e-18 * energy_of_turn / (turn * turn));
}

TEST_CASE("a beam on two supports swings with the frequency of its lumped masses, which tends to that of the theory") {
  // Modes of equal elements are sines: v = V sin kx, θ = T cos kx, with two equations for V and T at every node.
  const auto discrete = [](int n, const BeamSection& section) {
    const double h = length / n;
    const double k = std::numbers::pi / length;
    const double stiffness = section.young_modulus * section.second_moment();
    const double mass = section.density * section.area() * h;
    const double inertia =
        h * (section.density * section.area() * h * h / 12.0 + section.density * section.second_moment());
    const double vv = 24.0 * stiffness / (h * h * h) * (1.0 - std::cos(k * h)) / mass;
    const double vt = -12.0 * stiffness / (h * h) * std::sin(k * h);
    const double tt = stiffness / h * (8.0 + 4.0 * std::cos(k * h)) / inertia;
    const double middle = 0.5 * (vv + tt);
    const double square = middle - std::sqrt(0.25 * (vv - tt) * (vv - tt) + vt * vt / (mass * inertia));
    return std::pair(std::sqrt(square), vt / (square * inertia - tt * inertia));
  };
  const BeamSection section = steel(BeamTheory::euler_bernoulli);
  // Sections have a rotational inertia (Rayleigh).
  const double square_of_k = std::pow(std::numbers::pi / length, 2);
  const double mass_of_k = section.density * (section.area() + square_of_k * section.second_moment());
  const double theory = square_of_k * std::sqrt(section.young_modulus * section.second_moment() / mass_of_k);
  double error_before = 1.0;
  for (const int n : {4, 8, 16}) {
    const auto [frequency, ratio] = discrete(n, section);
    const double error = std::abs(frequency / theory - 1.0);
    CHECK(error < 0.3 * error_before);
    error_before = error;

    Model model = beam_model(n, BeamTheory::euler_bernoulli);
    SimulationChoice choice;
    choice.prescribed = held(0, {0, 1});
    for (const PrescribedFreedom& freedom : held(static_cast<Index>(n), {1})) choice.prescribed.push_back(freedom);
    choice.time_step.factor = 0.2;
    Simulation simulation = make_simulation(std::move(model), std::move(choice));
    constexpr double amplitude = 1e-3;
    const double k = std::numbers::pi / length;
    deform(
        simulation,
        [&](const Vector& place) {
          return Vector{0.0, amplitude * std::sin(k * component(place, 0))};
        },
        [&, slope = ratio](const Vector& place) { return slope * amplitude * std::cos(k * component(place, 0)); });
    simulation.step();
    EnergyDrift drift(simulation);
    const double start = simulation.state().beam_nodes.translation.displacement[n / 2].y;
    double before = start;
    while (simulation.state().beam_nodes.translation.displacement[n / 2].y > 0.0) {
      before = simulation.state().beam_nodes.translation.displacement[n / 2].y;
      simulation.step();
      drift.measure(simulation);
    }
    const double after = simulation.state().beam_nodes.translation.displacement[n / 2].y;
    const double step = simulation.state().clock.time_step;
    const double quarter = simulation.state().clock.time - step + step * before / (before - after);
    CHECK(quarter == doctest::Approx(0.5 * std::numbers::pi / frequency).epsilon(0.01));
    CHECK(drift.largest() < 1e-9);
  }
  CHECK(error_before < 0.01);
}

TEST_CASE("the bound of a beam holds: steps below it are stable, whatever swings") {
  for (const BeamTheory theory : {BeamTheory::euler_bernoulli, BeamTheory::timoshenko}) {
    Model model = beam_model(5, theory, {0.8, -0.6});
    SimulationChoice choice;
    choice.time_step.factor = 0.99;
    Simulation simulation = make_simulation(std::move(model), std::move(choice));
    double sign = 1.0;
    deform(
        simulation,
        [&sign](const Vector&) {
          return (sign = -sign) * Vector{1e-6, 2e-6};
        },
        [&sign](const Vector&) { return 3e-5 * sign; });
    simulation.step();
    const double start = energy(simulation, "elastic_beams") + std::abs(energy(simulation, "kinetic_beams"));
    for (int step = 0; step < 2000; ++step) simulation.step();
    CHECK(energy(simulation, "elastic_beams") < 50.0 * start);
  }
}
