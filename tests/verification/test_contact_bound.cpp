#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "generation/hexagonal.hpp"
#include "reference/assembled_stiffness.hpp"
#include "reference/freedoms.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/meshed_model.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Lumped masses of all freedoms.
Eigen::VectorXd masses(const Model& model, const State& state) {
  const reference::Freedoms freedoms(model);
  Eigen::VectorXd mass(freedoms.count());
  for (Eigen::Index i = 0; i < freedoms.n_particles; ++i) {
    mass[freedoms.particle(i, 0)] = mass[freedoms.particle(i, 1)] = state.particles.translation.mass[i];
    mass[freedoms.rotation(i)] = state.particles.rotation.inertia[i];
  }
  for (Eigen::Index i = 0; i < freedoms.n_nodes; ++i) {
    mass[freedoms.node(i, 0)] = mass[freedoms.node(i, 1)] = state.nodes.translation.mass[i];
  }
  return mass;
}

/// The largest ω² of M⁻¹K, all freedoms free.
double largest_square(const Simulation& simulation) {
  const Eigen::MatrixXd stiffness = reference::assemble_stiffness(simulation.model(), simulation.state());
  const Eigen::VectorXd root = masses(simulation.model(), simulation.state()).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

/// Gershgorin's bound of the same.
double bound_of_square(const Simulation& simulation) {
  const StiffnessBounds bounds = simulation.stiffness_bounds();
  const Model& model = simulation.model();
  const State& state = simulation.state();
  double largest = 0.0;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const double radius = model.particles.radius[i];
    largest = std::max({largest, bounds.particle_translation[i] / state.particles.translation.mass[i],
                        bounds.particle_rotation[i] * radius * radius / state.particles.rotation.inertia[i]});
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    largest = std::max(largest, bounds.node_translation[i] / state.nodes.translation.mass[i]);
  }
  return largest;
}

/// Discs of sizes 1 to 5 thrown into a hole of a mesh, bonded to each other and to its border.
Model random_assembly(RandomNumbers& random) {
  Model model = empty_model({.poisson_ratio = random.uniform(0.0, 0.45), .detection_gap = 0.2, .interface_gap = 0.5});
  add_mesh(model, {even_lines(0.0, 0.6, 3), even_lines(0.0, 0.6, 3)}, {{{0.2, 0.2}, {0.4, 0.4}}});
  for (int i = 0; i < 40; ++i) {
    const double radius = random.uniform(0.01, 0.05);
    add_particle(model,
                 {random.uniform(0.2 + 0.5 * radius, 0.4 - 0.5 * radius),
                  random.uniform(0.2 + 0.5 * radius, 0.4 - 0.5 * radius)},
                 radius);
  }
  return model;
}

}  // namespace

TEST_CASE("the bound of the stiffness is one, for random assemblies with their interface, real or scaled masses") {
  RandomNumbers random(31);
  double tightest = 0.0;
  for (int trial = 0; trial < 12; ++trial) {
    SimulationChoice choice;
    choice.time_step.masses = trial % 2 == 0 ? Masses::real : Masses::scaled;
    const Simulation simulation = make_simulation(random_assembly(random), std::move(choice));
    REQUIRE(simulation.state().facet_contacts.size() > 5);
    const double ratio = largest_square(simulation) / bound_of_square(simulation);
    CHECK(ratio <= 1.0);
    CHECK(ratio > 0.3);
    tightest = std::max(tightest, ratio);
  }
  MESSAGE("the true ω² reaches " << tightest << " of the bound");
}

TEST_CASE("the bound of a lone bonded pair is reached to a rounding") {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.1);
  add_particle(model, {0.12, 0.16}, 0.1);
  const Simulation simulation = make_simulation(std::move(model));
  // Normal: 2 k_n / m against the bound's 2 k_n / m; the shear motions lie below with ν = 0.2.
  const double k_n = simulation.state().particle_contacts.normal_stiffness[0];
  const double k_s = simulation.state().particle_contacts.shear_stiffness[0];
  const double mass = simulation.model().particles.real_mass[0];
  CHECK(largest_square(simulation) == doctest::Approx(std::max(2.0 * k_n, 6.0 * k_s) / mass).epsilon(1e-10));
  CHECK(bound_of_square(simulation) == doctest::Approx(8.0 * k_s / mass).epsilon(1e-10));
}

TEST_CASE("the paper's rotation bound k_s d² alone is none: all discs turning alike reach ωΔt = 2.83") {
  // A hexagonal patch; masses scaled after Eqs (30)-(32) with Δt = 1, inertia with k_rot = Σ k_s r².
  Model model = empty_model({.poisson_ratio = 0.2, .stiffness = StiffnessFormula::hexagonal});
  constexpr double radius = 0.1;
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 9; ++column) {
      add_particle(model, {2.0 * radius * (column + 0.5 * (row % 2)), std::sqrt(3.0) * radius * row}, radius);
    }
  }
  const Simulation simulation = make_simulation(std::move(model));
  const ContactTable& contacts = simulation.state().particle_contacts;
  const auto n_particles = static_cast<Eigen::Index>(simulation.model().particles.size());
  Eigen::VectorXd rotation_row = Eigen::VectorXd::Zero(n_particles);
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    for (const Index i : {contacts.first[row], contacts.second[row]}) {
      rotation_row[i] += contacts.shear_stiffness[row] * radius * radius;
    }
  }
  const Eigen::VectorXd inertia = 0.25 * rotation_row;
  const Eigen::MatrixXd stiffness = reference::assemble_stiffness(simulation.model(), simulation.state());
  const reference::Freedoms freedoms(simulation.model());
  Eigen::VectorXd uniform = Eigen::VectorXd::Zero(freedoms.count());
  double kinetic = 0.0;
  for (Eigen::Index i = 0; i < n_particles; ++i) {
    uniform[freedoms.rotation(i)] = 1.0;
    kinetic += inertia[i];
  }
  const double omega = std::sqrt(uniform.dot(stiffness * uniform) / kinetic);
  CHECK(omega == doctest::Approx(2.0 * std::sqrt(2.0)).epsilon(1e-10));
}
