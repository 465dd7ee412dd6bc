#include "integrator/dynamic_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/parameters.hpp"

namespace ligament {
namespace {

/// Numerator and denominator of the Rayleigh quotient.
struct Quotient {
  double stiffness = 0.0;  ///< xᵀSx (J)
  double mass = 0.0;       ///< xᵀMx (J s2)
  Quotient& operator+=(const Quotient& b) {
    stiffness += b.stiffness;
    mass += b.mass;
    return *this;
  }
};

Quotient quotient(const TranslationState& bodies, const Field<Vector>& free, const Field<Vector>& force_before) {
  return block_sum(bodies.force.size(), [&](std::size_t i) {
    const Vector motion = componentwise(free[i], bodies.increment[i]);
    return Quotient{-dot(motion, bodies.force[i] - force_before[i]), bodies.mass[i] * dot(motion, motion)};
  });
}

Quotient quotient(const RotationState& bodies, const Field<double>& free, const Field<Moment>& moment_before) {
  return block_sum(bodies.moment.size(), [&](std::size_t i) {
    const Rotation motion = free[i] * bodies.increment[i];
    return Quotient{-motion * (bodies.moment[i] - moment_before[i]), bodies.inertia[i] * motion * motion};
  });
}

}  // namespace

void DynamicRelaxation::declare(Parameters& parameters) {
  parameters
      .number("damping_ratio", damping_ratio_, "damping over the critical one of the frequency that the motion shows")
      .greater_than(0.0);
  parameters.number("largest_damping", largest_damping_, "upper bound of c Δt; above 2 the damping would overshoot")
      .greater_than(0.0)
      .less_than(2.0);
}

DampingCoefficients DynamicRelaxation::coefficients(const Model& model, State& state) {
  RelaxationState& memory = state.relaxation;
  const bool is_first =
      memory.node_force.size() != model.nodes.size() || memory.particle_force.size() != model.particles.size();
  Quotient sum;
  if (!is_first) {
    sum += quotient(state.particles.translation, model.particles.free, memory.particle_force);
    sum += quotient(state.particles.rotation, model.particles.rotation_free, memory.particle_moment);
    sum += quotient(state.nodes.translation, model.nodes.free, memory.node_force);
  }
  memory.particle_force = state.particles.translation.force;
  memory.particle_moment = state.particles.rotation.moment;
  memory.node_force = state.nodes.translation.force;
  // Where the stiffness along the motion is negative, as in a snap, damping would only hold it up.
  const double frequency = sum.stiffness > 0.0 && sum.mass > 0.0 ? std::sqrt(sum.stiffness / sum.mass) : 0.0;
  memory.damping = std::min(2.0 * damping_ratio_ * frequency, largest_damping_ / state.clock.acceleration_time());
  return {.viscous = memory.damping};
}

}  // namespace ligament
