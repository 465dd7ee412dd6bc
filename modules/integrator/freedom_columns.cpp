#include "integrator/freedom_columns.hpp"

#include "core/block_sum.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {
namespace {

/// Puts translation(i), rotation(i) of particles and node(i) where they are free.
template <class Translation, class Rotation, class Node>
std::vector<double> free_column(const Model& model, Translation&& translation, Rotation&& rotation, Node&& node) {
  std::vector<double> column;
  column.reserve(FreedomNumbers(model).count());
  const auto add = [&column](const Vector& value) {
    for (int axis = 0; axis < dimension; ++axis) column.push_back(component(value, axis));
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    add(componentwise(model.particles.free[i], translation(i)));
    column.push_back(model.particles.rotation_free[i] * rotation(i));
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) add(componentwise(model.nodes.free[i], node(i)));
  return column;
}

/// The same from a field of each table.
std::vector<double> free_column(const Model& model, const Field<Vector>& translation, const Field<double>& rotation,
                                const Field<Vector>& node) {
  return free_column(
      model, [&](std::size_t i) { return translation[i]; }, [&](std::size_t i) { return rotation[i]; },
      [&](std::size_t i) { return node[i]; });
}

/// ½ m v(n-½) v(n+½) along the directions in which a body is held.
double held_kinetic_energy(const TranslationState& bodies, const Field<Vector>& free) {
  return block_sum(bodies.velocity.size(), [&](std::size_t i) {
    const Vector held = uniform_vector(1.0) - free[i];
    return 0.5 * bodies.mass[i] * dot(componentwise(held, bodies.velocity_before[i]), bodies.velocity[i]);
  });
}

}  // namespace

std::vector<double> free_forces(const Model& model, const State& state) {
  return free_column(model, state.particles.translation.force, state.particles.rotation.moment,
                     state.nodes.translation.force);
}

std::vector<double> free_velocities(const Model& model, const State& state) {
  return free_column(model, state.particles.translation.velocity, state.particles.rotation.spin,
                     state.nodes.translation.velocity);
}

std::vector<double> free_velocities_before(const Model& model, const State& state) {
  return free_column(model, state.particles.translation.velocity_before, state.particles.rotation.spin_before,
                     state.nodes.translation.velocity_before);
}

std::vector<double> free_increments(const Model& model, const State& state) {
  return free_column(model, state.particles.translation.increment, state.particles.rotation.increment,
                     state.nodes.translation.increment);
}

std::vector<double> inverse_masses(const Model& model, const State& state) {
  const TranslationState& particles = state.particles.translation;
  return free_column(
      model, [&](std::size_t i) { return uniform_vector(1.0 / particles.mass[i]); },
      [&](std::size_t i) { return 1.0 / state.particles.rotation.inertia[i]; },
      [&](std::size_t i) { return uniform_vector(1.0 / state.nodes.translation.mass[i]); });
}

void set_free_velocities(const Model& model, const std::vector<double>& velocities, State& state) {
  std::size_t next = 0;
  const auto set = [&](TranslationState& bodies, const Field<Vector>& free, std::size_t i) {
    bodies.velocity_before[i] = bodies.velocity[i];
    for (int axis = 0; axis < dimension; ++axis, ++next) {
      if (component(free[i], axis) != 0.0) set_component(bodies.velocity[i], axis, velocities[next]);
    }
  };
  RotationState& rotation = state.particles.rotation;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    set(state.particles.translation, model.particles.free, i);
    rotation.spin_before[i] = rotation.spin[i];
    if (model.particles.rotation_free[i] != 0.0) rotation.spin[i] = velocities[next];
    ++next;
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) set(state.nodes.translation, model.nodes.free, i);
}

double prescribed_kinetic_energy(const Model& model, const State& state) {
  const RotationState& rotation = state.particles.rotation;
  return held_kinetic_energy(state.particles.translation, model.particles.free) +
         held_kinetic_energy(state.nodes.translation, model.nodes.free) +
         block_sum(rotation.spin.size(), [&](std::size_t i) {
           const double held = 1.0 - model.particles.rotation_free[i];
           return 0.5 * held * rotation.inertia[i] * rotation.spin_before[i] * rotation.spin[i];
         });
}

}  // namespace ligament
