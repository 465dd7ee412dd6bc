#pragma once

#include "core/vector.hpp"

namespace ligament {

/// For every body a number that bounds the stiffness it feels: with D = diag of these, K ≤ D as quadratic forms, so
/// that ω²max ≤ max D_i / m_i (Gershgorin, row by row; a contact counts its rows in its own frame, which makes the
/// bound independent of orientation). Rotations of
/// particles are scaled by the radius, θ' = R θ.
struct StiffnessBounds {
  Field<double> particle_translation;  ///< N/m
  Field<double> particle_rotation;     ///< N/m, of θ' = R θ
  Field<double> node_translation;      ///< N/m
  Field<double> beam_translation;      ///< N/m
  Field<double> beam_rotation;         ///< N/m, of θ' = l θ, see BeamNodeData::lever

  StiffnessBounds(std::size_t n_particles, std::size_t n_nodes, std::size_t n_beam_nodes = 0)
      : particle_translation(n_particles, 0.0),
        particle_rotation(n_particles, 0.0),
        node_translation(n_nodes, 0.0),
        beam_translation(n_beam_nodes, 0.0),
        beam_rotation(n_beam_nodes, 0.0) {}
};

}  // namespace ligament
