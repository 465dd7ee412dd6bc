#include <doctest/doctest.h>

#include <cmath>

#include "integrator/time_step.hpp"
#include "reference/direct_solution.hpp"
#include "support/element_model.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Masses and inertias of the state, in the order of the assembled stiffness.
Eigen::VectorXd inertia_column(const Model& model, const State& state) {
  const reference::Freedoms freedoms(model);
  Eigen::VectorXd inertia(freedoms.count());
  for (Eigen::Index i = 0; i < freedoms.n_particles; ++i) {
    inertia[freedoms.particle(i, 0)] = inertia[freedoms.particle(i, 1)] = state.particles.translation.mass[i];
    inertia[freedoms.rotation(i)] = state.particles.rotation.inertia[i];
  }
  for (Eigen::Index i = 0; i < freedoms.n_nodes; ++i) {
    inertia[freedoms.node(i, 0)] = inertia[freedoms.node(i, 1)] = state.nodes.translation.mass[i];
  }
  return inertia;
}

/// The largest ω² of all motions, by power iteration on M^-½ K M^-½; from below.
double largest_frequency_squared(const Model& model, const State& state) {
  const Eigen::SparseMatrix<double> stiffness = reference::assemble_stiffness(model, state);
  const Eigen::VectorXd weight = inertia_column(model, state).cwiseSqrt().cwiseInverse();
  RandomNumbers random(1);
  Eigen::VectorXd mode(stiffness.rows());
  for (Eigen::Index i = 0; i < mode.size(); ++i) mode[i] = random.uniform(-1.0, 1.0);
  double quotient = 0.0;
  for (int i = 0; i < 3000; ++i) {
    mode.normalize();
    const Eigen::VectorXd next = weight.cwiseProduct(stiffness * weight.cwiseProduct(mode));
    quotient = mode.dot(next);
    mode = next;
  }
  return quotient;
}

/// Scaled masses without safety and a time step of 1: (ω Δt)² must not exceed 4, nor fall far below.
double step_squared(Model model) {
  SimulationChoice choice;
  choice.time_step = {.masses = Masses::scaled, .safety = 1.0, .time_step = 1.0};
  const Simulation simulation = make_simulation(std::move(model), std::move(choice));
  return largest_frequency_squared(simulation.model(), simulation.state());
}

/// Elements of random shape, nodes displaced by up to a quarter of the spacing.
Model random_patch(RandomNumbers& random, PlaneState plane) {
  const double aspect = random.uniform(0.3, 3.0);
  const GridLines lines{even_lines(0.0, 5.0 * aspect, 5), even_lines(0.0, 4.0, 4)};
  const auto place = [&](const Vector& p) { return p + componentwise({aspect, 1.0}, random.vector(0.24)); };
  return element_model(mapped(build_structured_mesh(lines, {}), place), {.young_modulus = random.uniform(1.0, 100.0),
                                                                         .poisson_ratio = random.uniform(0.0, 0.45),
                                                                         .thickness = random.uniform(0.1, 2.0),
                                                                         .plane = plane});
}

/// Discs of different radius that overlap or are apart a little, all neighbours bonded.
Model random_assembly(RandomNumbers& random, double poisson_ratio) {
  Model model = empty_model({.poisson_ratio = poisson_ratio, .detection_gap = 0.15});
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const Vector place = Vector{i + 0.5 * (j % 2), 0.9 * j} + random.vector(0.1);
      add_particle(model, place, random.uniform(0.4, 0.6));
    }
  }
  return model;
}

/// A row of discs along the side of a patch of elements, linked to it.
Model random_hybrid(RandomNumbers& random) {
  Model model = empty_model({.detection_gap = 0.1, .interface_gap = 0.5});
  add_mesh(model, {even_lines(0.0, 6.0, 4), even_lines(-2.0, 0.0, 2)});
  for (int i = 0; i < 6; ++i) {
    add_particle(model, {i + 0.5 + random.uniform(-0.1, 0.1), random.uniform(0.3, 0.5)}, 0.5);
  }
  return model;
}

}  // namespace

TEST_CASE("elements: masses scaled by the bound make every motion stable") {
  RandomNumbers random(7);
  for (int i = 0; i < 10; ++i) {
    const double squared = step_squared(random_patch(random, i % 2 == 0 ? PlaneState::stress : PlaneState::strain));
    CHECK(squared <= 4.0);
    CHECK(squared > 2.0);
  }
}

TEST_CASE("particles: masses scaled by the bound make every motion stable, rotations included") {
  RandomNumbers random(11);
  for (int i = 0; i < 10; ++i) {
    const double squared = step_squared(random_assembly(random, 0.03 * i));
    CHECK(squared <= 4.0);
    CHECK(squared > 2.0);
  }
}

TEST_CASE("particles and elements: masses scaled by the bound make every motion stable") {
  RandomNumbers random(13);
  for (int i = 0; i < 10; ++i) {
    const double squared = step_squared(random_hybrid(random));
    CHECK(squared <= 4.0);
    CHECK(squared > 2.0);
  }
}

TEST_CASE("the critical time step of real masses is below the true one") {
  RandomNumbers random(17);
  for (int i = 0; i < 5; ++i) {
    const Simulation simulation = make_simulation(random_hybrid(random));
    const double frequency = std::sqrt(largest_frequency_squared(simulation.model(), simulation.state()));
    const CriticalTimeStep critical =
        critical_time_step(simulation.model(), simulation.state(), simulation.stiffness_bounds());
    CHECK(critical.time_step <= 2.0 / frequency);
    CHECK(critical.time_step > 1.0 / frequency);
    CHECK(critical.limiting_body == simulation.limiting_body());
  }
}

TEST_CASE("the paper's row sums (30)-(32) are no bound: they leave out that shear couples rotations") {
  Model model = empty_model({.poisson_ratio = 0.0});
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) add_particle(model, {i + 0.5 * (j % 2), std::sqrt(0.75) * j}, 0.5);
  }
  const Simulation simulation = make_simulation(std::move(model));
  State state = simulation.state();
  std::fill(state.particles.translation.mass.begin(), state.particles.translation.mass.end(), 0.0);
  std::fill(state.particles.rotation.inertia.begin(), state.particles.rotation.inertia.end(), 0.0);
  const ContactTable& contacts = state.particle_contacts;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    for (const Index body : {contacts.first[row], contacts.second[row]}) {
      const double normal = contacts.normal_stiffness[row];
      const double shear = contacts.shear_stiffness[row];
      state.particles.translation.mass[body] += 0.25 * (2.0 * normal + 2.0 * shear);
      state.particles.rotation.inertia[body] += 0.25 * shear * 0.25;
    }
  }
  CHECK(std::sqrt(largest_frequency_squared(simulation.model(), state)) > 2.8);
}
