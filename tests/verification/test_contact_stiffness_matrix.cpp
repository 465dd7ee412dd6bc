#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "reference/assembled_stiffness.hpp"
#include "reference/direct_solution.hpp"
#include "support/random_numbers.hpp"
#include "support/three_kinds_of_contact.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A disc on a facet, at random places and in random directions.
struct DiscOnFacet {
  Model model = empty_model();
  State state;
  Vector normal;
  double share = 0.0;
  double distance = 0.0;

  explicit DiscOnFacet(RandomNumbers& random) {
    const Vector axial = random.direction();
    const double length = random.uniform(0.5, 2.0);
    normal = tangent(axial);
    share = random.uniform(0.05, 0.95);
    distance = random.uniform(0.06, 0.1);
    const Vector start = random.vector(1.0);
    add_node(model, start);
    add_node(model, start + length * axial);
    add_facet(model, 0, 1);
    add_particle(model, start + share * length * axial - distance * normal, 0.1);
    state = resting_state(model);
    GridContactDetector(1e-6).bond(model, state);
  }
};

/// Forces on all freedoms after a step from the state at rest.
template <class Pairing>
Eigen::VectorXd forces_at(const Model& model, State state, const Eigen::VectorXd& u) {
  const auto displacement = reference::from_column(model, u);
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    displace(state.particles.translation, i, displacement.particle[i]);
    rotate(state.particles.rotation, i, displacement.rotation[i]);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) displace(state.nodes.translation, i, displacement.node[i]);
  clear_forces(state);
  ContactForces<Pairing>().add_forces(model, state);
  reference::FreedomValues forces(model);
  forces.particle = state.particles.translation.force;
  forces.rotation = state.particles.rotation.moment;
  forces.node = state.nodes.translation.force;
  return reference::to_column(model, forces);
}

/// -∂F/∂u by central differences.
template <class Pairing>
Eigen::MatrixXd differenced_stiffness(const Model& model, const State& state) {
  constexpr double step = 1e-6;
  const Eigen::Index count = reference::Freedoms(model).count();
  Eigen::MatrixXd stiffness(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Eigen::VectorXd u = step * Eigen::VectorXd::Unit(count, j);
    stiffness.col(j) = (forces_at<Pairing>(model, state, -u) - forces_at<Pairing>(model, state, u)) / (2.0 * step);
  }
  return stiffness;
}

/// Eq. (29) as printed: node i (n, t), node j (n, t), disc (n, t, θ), with rotations counted clockwise.
Eigen::Matrix<double, 7, 7> printed_stiffness(double k_n, double k_s, double n_i, double n_j, double d) {
  Eigen::Matrix<double, 7, 7> k;
  k << k_n * n_i * n_i, 0, k_n * n_i * n_j, 0, -k_n * n_i, 0, 0,             //
      0, k_s * n_i * n_i, 0, k_s * n_i * n_j, 0, -k_s * n_i, d * k_s * n_i,  //
      k_n * n_i * n_j, 0, k_n * n_j * n_j, 0, -k_n * n_j, 0, 0,              //
      0, k_s * n_i * n_j, 0, k_s * n_j * n_j, 0, -k_s * n_j, d * k_s * n_j,  //
      -k_n * n_i, 0, -k_n * n_j, 0, k_n, 0, 0,                               //
      0, -k_s * n_i, 0, -k_s * n_j, 0, k_s, -d * k_s,                        //
      0, d * k_s * n_i, 0, d * k_s * n_j, 0, -d * k_s, d * d * k_s;
  return k;
}

}  // namespace

TEST_CASE("Eq. (29) is the derivative of the contact forces of a disc on a facet") {
  RandomNumbers random(10);
  for (int trial = 0; trial < 50; ++trial) {
    const DiscOnFacet bodies(random);
    REQUIRE(bodies.state.facet_contacts.size() == 1);
    const double k_n = bodies.state.facet_contacts.normal_stiffness[0];
    const auto printed = printed_stiffness(k_n, bodies.state.facet_contacts.shear_stiffness[0], 1.0 - bodies.share,
                                           bodies.share, bodies.distance);
    // From the global freedoms (disc x, y, θ, node i x, y, node j x, y) to the local ones.
    Eigen::Matrix<double, 7, 7> local = Eigen::Matrix<double, 7, 7>::Zero();
    const Vector along = tangent(bodies.normal);
    for (const auto& [row, column] : {std::pair{0, 3}, {2, 5}, {4, 0}}) {
      local(row, column) = bodies.normal.x;
      local(row, column + 1) = bodies.normal.y;
      local(row + 1, column) = along.x;
      local(row + 1, column + 1) = along.y;
    }
    local(6, 2) = -1.0;
    const Eigen::MatrixXd expected = local.transpose() * printed * local;
    const Eigen::MatrixXd got = differenced_stiffness<FacetPairing>(bodies.model, bodies.state);
    CHECK((got - expected).cwiseAbs().maxCoeff() < 1e-8 * k_n);
  }
}

TEST_CASE("the assembled stiffness is the derivative of the forces, for all three kinds of contact") {
  const ThreeKindsOfContact bodies;
  const double scale = bodies.state.facet_contacts.normal_stiffness[0];
  Eigen::MatrixXd got = differenced_stiffness<ParticlePairing>(bodies.model, bodies.state);
  got += differenced_stiffness<FacetPairing>(bodies.model, bodies.state);
  got += differenced_stiffness<CornerPairing>(bodies.model, bodies.state);
  const Eigen::MatrixXd expected = reference::assemble_stiffness(bodies.model, bodies.state);
  CHECK((got - expected).cwiseAbs().maxCoeff() < 1e-8 * scale);
  // Three kinds times two springs: of 3·3 + 4·2 freedoms as many directions are stiff as there are springs.
  CHECK(Eigen::FullPivLU<Eigen::MatrixXd>(expected).setThreshold(1e-9).rank() == 6);
}
