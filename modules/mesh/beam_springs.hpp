#pragma once

#include <array>

#include "core/model.hpp"
#include "core/state.hpp"

/// The stiffness of a 2-node beam, straight and of constant section, is the sum of three springs: its elongation, the
/// difference of the rotations of its ends (a constant moment), and what the rotations lack to follow the turn of its
/// axis (a constant shear force). Rigid motions stretch none of them.
namespace ligament {

struct BeamMode {
  double stretch = 0.0;    ///< (m, or rad of the constant moment)
  double stiffness = 0.0;  ///< (N/m, or N m)
};

/// At rest.
struct BeamAxis {
  Vector axial;  ///< unit vector from the first node to the second
  double length = 0.0;
};
inline BeamAxis beam_axis(const Model& model, std::size_t element) {
  const auto& [i, j] = model.beam_elements.nodes[element];
  const Vector axis = model.beam_nodes.position[j] - model.beam_nodes.position[i];
  return {axis / norm(axis), norm(axis)};
}

/// Elongation, constant moment, constant shear force.
inline std::array<BeamMode, 3> beam_modes(const Model& model, const State& state, std::size_t element) {
  const auto& [i, j] = model.beam_elements.nodes[element];
  const BeamAxis axis = beam_axis(model, element);
  const Vector apart = state.beam_nodes.translation.displacement[j] - state.beam_nodes.translation.displacement[i];
  const Rotation turn_i = state.beam_nodes.rotation.rotation[i];
  const Rotation turn_j = state.beam_nodes.rotation.rotation[j];
  return {
      BeamMode{dot(axis.axial, apart), model.beam_elements.axial[element]},
      BeamMode{turn_j - turn_i, model.beam_elements.bending[element]},
      BeamMode{cross(axis.axial, apart) - 0.5 * axis.length * (turn_i + turn_j), model.beam_elements.shear[element]}};
}

}  // namespace ligament
