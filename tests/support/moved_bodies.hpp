#pragma once

#include <algorithm>
#include <cmath>

#include "core/model.hpp"
#include "core/state.hpp"

/// Motions prescribed to all bodies of a state at once.
namespace ligament::support {

/// x → centre + Q(angle) (x - centre) + shift.
struct RigidMotion {
  Vector centre;
  double angle = 0.0;
  Vector shift;

  [[nodiscard]] Vector displacement(const Vector& place) const {
    // cos - 1 written so that small angles lose no digits.
    const double half_sine = std::sin(0.5 * angle);
    const Vector arm = place - centre;
    return (-2.0 * half_sine * half_sine) * arm + cross(std::sin(angle), arm) + shift;
  }
};

inline void clear_forces(State& state) {
  std::fill(state.particles.translation.force.begin(), state.particles.translation.force.end(), Vector{});
  std::fill(state.particles.rotation.moment.begin(), state.particles.rotation.moment.end(), 0.0);
  std::fill(state.nodes.translation.force.begin(), state.nodes.translation.force.end(), Vector{});
}

inline void displace(TranslationState& bodies, std::size_t row, const Vector& displacement) {
  bodies.increment[row] = displacement - bodies.displacement[row];
  bodies.displacement[row] = displacement;
}

inline void rotate(RotationState& bodies, std::size_t row, Rotation rotation) {
  bodies.increment[row] = rotation - bodies.rotation[row];
  bodies.rotation[row] = rotation;
}

/// One step that takes all bodies to where the motion takes their places at rest; forces are cleared.
inline void move_rigidly(const Model& model, State& state, const RigidMotion& motion) {
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    displace(state.particles.translation, i, motion.displacement(model.particles.position[i]));
    rotate(state.particles.rotation, i, motion.angle);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    displace(state.nodes.translation, i, motion.displacement(model.nodes.position[i]));
  }
  clear_forces(state);
}

}  // namespace ligament::support
