#include "integrator/dynamic_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "integrator/body_loops.hpp"

namespace ligament {
namespace {

/// Numerator and denominator of the Rayleigh quotient, xᵀSx (J) and xᵀMx (J s2), of bodies that turn, against their
/// forces of the step before, which are then those of now.
TwoSums take_quotient(const TurningState& bodies, const Field<Vector>& free, const Field<double>& rotation_free,
                      Field<Vector>& force_before, Field<Moment>& moment_before) {
  force_before.resize(free.size());
  moment_before.resize(free.size());
  return sum_of_body_blocks(free.size(), [&](std::size_t begin, std::size_t end) {
    BlockTerms terms;
    add_rayleigh_terms(bodies.translation, free, force_before, {begin, end}, terms);
    add_rayleigh_terms(bodies.rotation, rotation_free, moment_before, {begin, end}, terms);
    return terms.sum(end - begin);
  });
}

/// Of all bodies.
TwoSums take_quotient(const Model& model, const State& state, RelaxationState& before) {
  TwoSums all = take_quotient(state.particles, model.particles.free, model.particles.rotation_free,
                              before.particle_force, before.particle_moment);
  before.node_force.resize(model.nodes.size());
  all += sum_of_body_blocks(model.nodes.size(), [&](std::size_t begin, std::size_t end) {
    BlockTerms terms;
    add_rayleigh_terms(state.nodes.translation, model.nodes.free, before.node_force, {begin, end}, terms);
    return terms.sum(end - begin);
  });
  all += take_quotient(state.beam_nodes, model.beam_nodes.free, model.beam_nodes.rotation_free, before.beam_force,
                       before.beam_moment);
  return all;
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
  const TwoSums quotient = take_quotient(model, state, memory);
  // Where the stiffness along the motion is negative, as in a snap, damping would only hold it up.
  const bool has_frequency = !is_first && quotient.first > 0.0 && quotient.second > 0.0;
  const double frequency = has_frequency ? std::sqrt(quotient.first / quotient.second) : 0.0;
  memory.damping = std::min(2.0 * damping_ratio_ * frequency, largest_damping_ / state.clock.acceleration_time());
  return {.viscous = memory.damping};
}

}  // namespace ligament
