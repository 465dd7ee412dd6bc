#include "integrator/dynamic_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/parallel.hpp"
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

Quotient quotient(const TranslationState& bodies, const Vector& free, const Field<Vector>& force_before,
                  std::size_t i) {
  const Vector motion = componentwise(free, bodies.increment[i]);
  return {-dot(motion, bodies.force[i] - force_before[i]), bodies.mass[i] * dot(motion, motion)};
}

Quotient quotient(const RotationState& bodies, double free, const Field<Moment>& moment_before, std::size_t i) {
  const Rotation motion = free * bodies.increment[i];
  return {-motion * (bodies.moment[i] - moment_before[i]), bodies.inertia[i] * motion * motion};
}

/// Of all bodies, against the forces of the step before.
Quotient quotient(const Model& model, const State& state) {
  const RelaxationState& before = state.relaxation;
  Quotient all = block_sum(model.particles.size(), [&](std::size_t i) {
    Quotient sum = quotient(state.particles.translation, model.particles.free[i], before.particle_force, i);
    sum += quotient(state.particles.rotation, model.particles.rotation_free[i], before.particle_moment, i);
    return sum;
  });
  all += block_sum(model.nodes.size(), [&](std::size_t i) {
    return quotient(state.nodes.translation, model.nodes.free[i], before.node_force, i);
  });
  all += block_sum(model.beam_nodes.size(), [&](std::size_t i) {
    Quotient sum = quotient(state.beam_nodes.translation, model.beam_nodes.free[i], before.beam_force, i);
    sum += quotient(state.beam_nodes.rotation, model.beam_nodes.rotation_free[i], before.beam_moment, i);
    return sum;
  });
  return all;
}

template <class T>
void remember(const Field<T>& now, Field<T>& memory) {
  memory.resize(now.size());
  parallel_ranges(now.size(), [&](std::size_t begin, std::size_t end) {
    std::copy(now.data() + begin, now.data() + end, memory.data() + begin);
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
  const bool is_first = memory.node_force.size() != model.nodes.size() ||
                        memory.particle_force.size() != model.particles.size() ||
                        memory.beam_force.size() != model.beam_nodes.size();
  const Quotient sum = is_first ? Quotient{} : quotient(model, state);
  remember(state.particles.translation.force, memory.particle_force);
  remember(state.particles.rotation.moment, memory.particle_moment);
  remember(state.nodes.translation.force, memory.node_force);
  remember(state.beam_nodes.translation.force, memory.beam_force);
  remember(state.beam_nodes.rotation.moment, memory.beam_moment);
  // Where the stiffness along the motion is negative, as in a snap, damping would only hold it up.
  const double frequency = sum.stiffness > 0.0 && sum.mass > 0.0 ? std::sqrt(sum.stiffness / sum.mass) : 0.0;
  memory.damping = std::min(2.0 * damping_ratio_ * frequency, largest_damping_ / state.clock.acceleration_time());
  return {.viscous = memory.damping};
}

}  // namespace ligament
