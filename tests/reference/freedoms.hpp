#pragma once

#include <Eigen/Core>

#include "core/model.hpp"

namespace ligament::reference {

/// Numbers all freedoms of a model in one column: x, y, θ of every particle, then x, y of every node.
struct Freedoms {
  Eigen::Index n_particles = 0;
  Eigen::Index n_nodes = 0;

  explicit Freedoms(const Model& model)
      : n_particles(static_cast<Eigen::Index>(model.particles.size())),
        n_nodes(static_cast<Eigen::Index>(model.nodes.size())) {}

  [[nodiscard]] Eigen::Index count() const { return 3 * n_particles + 2 * n_nodes; }
  [[nodiscard]] Eigen::Index particle(Eigen::Index row, int axis) const { return 3 * row + axis; }
  [[nodiscard]] Eigen::Index rotation(Eigen::Index row) const { return 3 * row + 2; }
  [[nodiscard]] Eigen::Index node(Eigen::Index row, int axis) const { return 3 * n_particles + 2 * row + axis; }
};

/// 1 for every freedom that is not prescribed, 0 for the others.
inline Eigen::VectorXd free_freedoms(const Model& model) {
  const Freedoms freedoms(model);
  Eigen::VectorXd free(freedoms.count());
  for (Eigen::Index i = 0; i < freedoms.n_particles; ++i) {
    for (int axis = 0; axis < dimension; ++axis) {
      free[freedoms.particle(i, axis)] = component(model.particles.free[i], axis);
    }
    free[freedoms.rotation(i)] = model.particles.rotation_free[i];
  }
  for (Eigen::Index i = 0; i < freedoms.n_nodes; ++i) {
    for (int axis = 0; axis < dimension; ++axis) free[freedoms.node(i, axis)] = component(model.nodes.free[i], axis);
  }
  return free;
}

}  // namespace ligament::reference
