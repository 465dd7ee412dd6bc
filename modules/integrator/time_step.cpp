#include "integrator/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/block_sum.hpp"

namespace ligament {
namespace {

/// m = (Δt²/4) · bound · safety for a whole table, the mean where there is no stiffness.
Field<double> scaled_masses(const Field<double>& bound, double time_step, double safety) {
  const auto n_stiff = std::count_if(bound.begin(), bound.end(), [](double value) { return value > 0.0; });
  const double sum = block_sum(bound.size(), [&](std::size_t i) { return bound[i]; });
  const double mean = n_stiff > 0 ? sum / static_cast<double>(n_stiff) : 1.0;
  Field<double> masses(bound.size());
  std::transform(bound.begin(), bound.end(), masses.begin(),
                 [&](double value) { return 0.25 * time_step * time_step * safety * (value > 0.0 ? value : mean); });
  return masses;
}

/// The same of rotations that are scaled by a lever each.
Field<double> scaled_inertias(const Field<double>& lever, const Field<double>& bound, double time_step, double safety) {
  Field<double> inertias = scaled_masses(bound, time_step, safety);
  for (std::size_t i = 0; i < inertias.size(); ++i) inertias[i] *= lever[i] * lever[i];
  return inertias;
}

}  // namespace

CriticalTimeStep critical_time_step(const Model& model, const State& state, const StiffnessBounds& bounds) {
  double largest = 0.0;
  std::string body = "none";
  const auto see = [&](double bound, double mass, const char* kind, Index id) {
    if (bound <= largest * mass) return;
    largest = bound / mass;
    body = fmt::format("{} {}", kind, id);
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const double radius = model.particles.radius[i];
    see(bounds.particle_translation[i], state.particles.translation.mass[i], "particle", model.particles.id[i]);
    see(bounds.particle_rotation[i] * radius * radius, state.particles.rotation.inertia[i], "rotation of particle",
        model.particles.id[i]);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    // The mass of a node that is held in every direction, as the ends of walls are, says nothing.
    if (model.nodes.free[i] == Vector{}) continue;
    see(bounds.node_translation[i], state.nodes.translation.mass[i], "node", model.nodes.id[i]);
  }
  const BeamNodeData& beams = model.beam_nodes;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams.free[i] != Vector{}) {
      see(bounds.beam_translation[i], state.beam_nodes.translation.mass[i], "beam node", beams.id[i]);
    }
    if (beams.rotation_free[i] == 0.0) continue;
    see(bounds.beam_rotation[i] * beams.lever[i] * beams.lever[i], state.beam_nodes.rotation.inertia[i],
        "rotation of beam node", beams.id[i]);
  }
  const double time_step = largest > 0.0 ? 2.0 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
  return {time_step, body};
}

void use_real_masses(const Model& model, State& state) {
  state.particles.translation.mass = model.particles.real_mass;
  // Ends of walls weigh nothing; held as they are, they need a mass to divide by, and no more.
  constexpr double next_to_nothing = 1e-30;
  state.nodes.translation.mass = model.nodes.real_mass;
  for (double& mass : state.nodes.translation.mass) mass = std::max(mass, next_to_nothing);
  state.beam_nodes.translation.mass = model.beam_nodes.real_mass;
  for (double& mass : state.beam_nodes.translation.mass) mass = std::max(mass, next_to_nothing);
  state.beam_nodes.rotation.inertia = model.beam_nodes.real_inertia;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    state.particles.rotation.inertia[i] =
        0.5 * model.particles.real_mass[i] * model.particles.radius[i] * model.particles.radius[i];
  }
}

void use_scaled_masses(const Model& model, State& state, const StiffnessBounds& bounds, double safety) {
  const double time_step = state.clock.time_step;
  state.particles.translation.mass = scaled_masses(bounds.particle_translation, time_step, safety);
  state.particles.rotation.inertia =
      scaled_inertias(model.particles.radius, bounds.particle_rotation, time_step, safety);
  state.nodes.translation.mass = scaled_masses(bounds.node_translation, time_step, safety);
  state.beam_nodes.translation.mass = scaled_masses(bounds.beam_translation, time_step, safety);
  state.beam_nodes.rotation.inertia = scaled_inertias(model.beam_nodes.lever, bounds.beam_rotation, time_step, safety);
}

double raise_scaled_masses(const Model& model, State& state, const StiffnessBounds& bounds, double safety) {
  const double time_step = state.clock.time_step;
  const auto raise = [safety](Field<double>& masses, const Field<double>& wanted, const auto& speed_squared) {
    return block_sum(masses.size(), [&](std::size_t i) {
      const double change = wanted[i] > safety * masses[i] ? wanted[i] - masses[i] : 0.0;
      masses[i] += change;
      return 0.5 * change * speed_squared(i);
    });
  };
  // Before the velocities of a step are updated, `velocity` still is v(n-½).
  TranslationState& particles = state.particles.translation;
  RotationState& rotation = state.particles.rotation;
  TranslationState& nodes = state.nodes.translation;
  TranslationState& beams = state.beam_nodes.translation;
  RotationState& beam_rotation = state.beam_nodes.rotation;
  return raise(particles.mass, scaled_masses(bounds.particle_translation, time_step, safety),
               [&](std::size_t i) { return dot(particles.velocity[i], particles.velocity[i]); }) +
         raise(rotation.inertia, scaled_inertias(model.particles.radius, bounds.particle_rotation, time_step, safety),
               [&](std::size_t i) { return rotation.spin[i] * rotation.spin[i]; }) +
         raise(nodes.mass, scaled_masses(bounds.node_translation, time_step, safety),
               [&](std::size_t i) { return dot(nodes.velocity[i], nodes.velocity[i]); }) +
         raise(beams.mass, scaled_masses(bounds.beam_translation, time_step, safety),
               [&](std::size_t i) { return dot(beams.velocity[i], beams.velocity[i]); }) +
         raise(beam_rotation.inertia, scaled_inertias(model.beam_nodes.lever, bounds.beam_rotation, time_step, safety),
               [&](std::size_t i) { return beam_rotation.spin[i] * beam_rotation.spin[i]; });
}

}  // namespace ligament
