#include "integrator/freedom_columns.hpp"

#include "core/block_sum.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {
namespace {

/// Puts translation(i), rotation(i) of particles and node(i) one after the other.
template <class Translation, class Rotation, class Node>
std::vector<double> column_of(const Model& model, Translation&& translation, Rotation&& rotation, Node&& node) {
  std::vector<double> column;
  column.reserve(FreedomNumbers(model).count());
  const auto add = [&column](const Vector& value) {
    for (int axis = 0; axis < dimension; ++axis) column.push_back(component(value, axis));
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    add(translation(i));
    column.push_back(rotation(i));
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) add(node(i));
  return column;
}

/// The same where they are free.
template <class Translation, class Rotation, class Node>
std::vector<double> free_column(const Model& model, Translation&& translation, Rotation&& rotation, Node&& node) {
  return column_of(
      model, [&](std::size_t i) { return componentwise(model.particles.free[i], translation(i)); },
      [&](std::size_t i) { return model.particles.rotation_free[i] * rotation(i); },
      [&](std::size_t i) { return componentwise(model.nodes.free[i], node(i)); });
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

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return block_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

std::vector<double> free_mask(const Model& model) {
  return column_of(
      model, [&](std::size_t i) { return model.particles.free[i]; },
      [&](std::size_t i) { return model.particles.rotation_free[i]; },
      [&](std::size_t i) { return model.nodes.free[i]; });
}

std::vector<double> all_forces(const Model& model, const State& state) {
  return column_of(
      model, [&](std::size_t i) { return state.particles.translation.force[i]; },
      [&](std::size_t i) { return state.particles.rotation.moment[i]; },
      [&](std::size_t i) { return state.nodes.translation.force[i]; });
}

std::vector<double> all_increments(const Model& model, const State& state) {
  return column_of(
      model, [&](std::size_t i) { return state.particles.translation.increment[i]; },
      [&](std::size_t i) { return state.particles.rotation.increment[i]; },
      [&](std::size_t i) { return state.nodes.translation.increment[i]; });
}

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

void move_bodies(const std::vector<double>& motion, State& state) {
  std::size_t next = 0;
  const auto move = [&](TranslationState& bodies, std::size_t i) {
    Vector part;
    for (int axis = 0; axis < dimension; ++axis) set_component(part, axis, motion[next++]);
    bodies.displacement[i] += part;
    bodies.increment[i] += part;
  };
  RotationState& rotation = state.particles.rotation;
  for (std::size_t i = 0; i < rotation.rotation.size(); ++i) {
    move(state.particles.translation, i);
    rotation.rotation[i] += motion[next];
    rotation.increment[i] += motion[next++];
  }
  for (std::size_t i = 0; i < state.nodes.translation.displacement.size(); ++i) move(state.nodes.translation, i);
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
