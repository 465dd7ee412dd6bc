#pragma once

#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "reference/assembled_stiffness.hpp"

/// Equilibrium in one go: K u = f with the assembled stiffness, small displacements about the configuration of the
/// state.
namespace ligament::reference {

/// Displacements, and the forces that hold prescribed freedoms (zero elsewhere).
struct DirectSolution {
  Field<Vector> node_displacement;      ///< (m)
  Field<Vector> particle_displacement;  ///< (m)
  Field<Rotation> particle_rotation;    ///< (rad)
  Field<Vector> node_reaction;          ///< (N)
  Field<Vector> particle_reaction;      ///< (N)
  Field<Moment> particle_moment;        ///< (N m)
};

/// A value for every freedom: loads (N, N m), or displacements (m, rad) of those that are prescribed.
struct FreedomValues {
  Field<Vector> node;
  Field<Vector> particle;
  Field<double> rotation;

  explicit FreedomValues(const Model& model)
      : node(model.nodes.size()), particle(model.particles.size()), rotation(model.particles.size(), 0.0) {}
};

inline Eigen::VectorXd to_column(const Model& model, const FreedomValues& values) {
  const Freedoms freedoms(model);
  Eigen::VectorXd column(freedoms.count());
  for (Eigen::Index i = 0; i < freedoms.n_particles; ++i) {
    column[freedoms.particle(i, 0)] = values.particle[i].x;
    column[freedoms.particle(i, 1)] = values.particle[i].y;
    column[freedoms.rotation(i)] = values.rotation[i];
  }
  for (Eigen::Index i = 0; i < freedoms.n_nodes; ++i) {
    column[freedoms.node(i, 0)] = values.node[i].x;
    column[freedoms.node(i, 1)] = values.node[i].y;
  }
  return column;
}

inline FreedomValues from_column(const Model& model, const Eigen::VectorXd& column) {
  const Freedoms freedoms(model);
  FreedomValues values(model);
  for (Eigen::Index i = 0; i < freedoms.n_particles; ++i) {
    values.particle[i] = {column[freedoms.particle(i, 0)], column[freedoms.particle(i, 1)]};
    values.rotation[i] = column[freedoms.rotation(i)];
  }
  for (Eigen::Index i = 0; i < freedoms.n_nodes; ++i) {
    values.node[i] = {column[freedoms.node(i, 0)], column[freedoms.node(i, 1)]};
  }
  return values;
}

/// Stiffness with the rows and columns of prescribed freedoms, and of those without any stiffness, replaced by ones on
/// the diagonal.
inline Eigen::SparseMatrix<double> supported_stiffness(const Eigen::SparseMatrix<double>& stiffness,
                                                       const Eigen::VectorXd& free) {
  Triplets triplets;
  for (Eigen::Index column = 0; column < stiffness.outerSize(); ++column) {
    bool has_stiffness = false;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, column); entry; ++entry) {
      if (free[entry.row()] == 0.0 || free[column] == 0.0) continue;
      has_stiffness = has_stiffness || (entry.row() == column && entry.value() > 0.0);
      triplets.emplace_back(entry.row(), column, entry.value());
    }
    if (!has_stiffness) triplets.emplace_back(column, column, 1.0);
  }
  Eigen::SparseMatrix<double> supported(stiffness.rows(), stiffness.cols());
  supported.setFromTriplets(triplets.begin(), triplets.end());
  return supported;
}

/// Solves for the free freedoms under loads and prescribed displacements (those of free freedoms are not looked at).
/// Throws std::runtime_error if the supports leave the model a mechanism.
inline DirectSolution solve_directly(const Model& model, const State& state, const FreedomValues& loads,
                                     const FreedomValues& prescribed) {
  const Eigen::SparseMatrix<double> stiffness = assemble_stiffness(model, state);
  const Eigen::VectorXd free = free_freedoms(model);
  const Eigen::VectorXd force = to_column(model, loads);
  Eigen::VectorXd u = to_column(model, prescribed);
  u.array() *= 1.0 - free.array();
  const Eigen::VectorXd right_side = (free.array() * (force - stiffness * u).array()).matrix();

  const Eigen::SparseMatrix<double> supported = supported_stiffness(stiffness, free);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(supported);
  if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 1e-14 * factors.vectorD().maxCoeff()) {
    throw std::runtime_error("the stiffness matrix is not positive definite: supports are missing");
  }
  Eigen::VectorXd correction = factors.solve(right_side);
  // One refinement takes the residual of badly scaled assemblies to rounding.
  correction += factors.solve(right_side - supported * correction);
  u += (free.array() * correction.array()).matrix();

  const FreedomValues displacement = from_column(model, u);
  const FreedomValues reaction = from_column(model, ((1.0 - free.array()) * (stiffness * u - force).array()).matrix());
  return {displacement.node, displacement.particle, displacement.rotation,
          reaction.node,     reaction.particle,     reaction.rotation};
}

/// The same with forces on nodes alone and supports that do not move.
inline DirectSolution solve_directly(const Model& model, const State& state, const Field<Vector>& node_loads) {
  FreedomValues loads(model);
  loads.node = node_loads;
  return solve_directly(model, state, loads, FreedomValues(model));
}

}  // namespace ligament::reference
