#include "integrator/freedom_columns.hpp"

#include "core/block_sum.hpp"
#include "core/body_table.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {
namespace {

/// Calls visit(table) for the tables of bodies in the order of FreedomNumbers.
template <class Visit>
void visit_tables(Visit&& visit) {
  for (const BodyTable table : {BodyTable::particle, BodyTable::node, BodyTable::beam_node}) visit(table);
}

using TranslationField = Field<Vector> TranslationState::*;
using RotationField = Field<double> RotationState::*;

/// Puts translation(i), and rotation(i) where there is one, of a table one after the other.
template <class Translation, class Rotation>
void append(BodyTable table, std::size_t count, Translation&& translation, Rotation&& rotation,
            std::vector<double>& column) {
  const bool turns = table != BodyTable::node;
  std::size_t next = column.size();
  column.resize(next + count * (turns ? dimension + 1 : dimension));
  double* values = column.data();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector value = translation(i);
    for (int axis = 0; axis < dimension; ++axis) values[next++] = component(value, axis);
    if (turns) values[next++] = rotation(i);
  }
}

/// Of a field of all translations and one of all rotations.
std::vector<double> all_column(const Model& model, const State& state, TranslationField translation,
                               RotationField rotation) {
  std::vector<double> column;
  column.reserve(FreedomNumbers(model).count());
  visit_tables([&](BodyTable table) {
    const Field<Vector>& translations = translation_of(state, table).*translation;
    const Field<double>& rotations = rotation_of(state, table).*rotation;
    append(
        table, translations.size(), [&](std::size_t i) { return translations[i]; },
        [&](std::size_t i) { return rotations[i]; }, column);
  });
  return column;
}

/// The same where they are free.
std::vector<double> free_column(const Model& model, const State& state, TranslationField translation,
                                RotationField rotation) {
  std::vector<double> column;
  column.reserve(FreedomNumbers(model).count());
  visit_tables([&](BodyTable table) {
    const Field<Vector>& translations = translation_of(state, table).*translation;
    const Field<double>& rotations = rotation_of(state, table).*rotation;
    const Field<Vector>& free = free_of(model, table);
    const Field<double>& rotation_free = rotation_free_of(model, table);
    append(
        table, translations.size(), [&](std::size_t i) { return componentwise(free[i], translations[i]); },
        [&](std::size_t i) { return rotation_free[i] * rotations[i]; }, column);
  });
  return column;
}

/// ½ m v(n-½) v(n+½) along the directions in which a body is held.
double held_kinetic_energy(const TranslationState& bodies, const Field<Vector>& free) {
  return block_sum(bodies.velocity.size(), [&](std::size_t i) {
    const Vector held = uniform_vector(1.0) - free[i];
    return 0.5 * bodies.mass[i] * dot(componentwise(held, bodies.velocity_before[i]), bodies.velocity[i]);
  });
}

double held_kinetic_energy(const RotationState& bodies, const Field<double>& free) {
  return block_sum(bodies.spin.size(), [&](std::size_t i) {
    return 0.5 * (1.0 - free[i]) * bodies.inertia[i] * bodies.spin_before[i] * bodies.spin[i];
  });
}

}  // namespace

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return block_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

std::vector<double> free_mask(const Model& model) {
  std::vector<double> column;
  visit_tables([&](BodyTable table) {
    const Field<Vector>& free = free_of(model, table);
    const Field<double>& rotation_free = rotation_free_of(model, table);
    append(
        table, free.size(), [&](std::size_t i) { return free[i]; }, [&](std::size_t i) { return rotation_free[i]; },
        column);
  });
  return column;
}

std::vector<double> all_displacements(const Model& model, const State& state) {
  return all_column(model, state, &TranslationState::displacement, &RotationState::rotation);
}

std::vector<double> all_forces(const Model& model, const State& state) {
  return all_column(model, state, &TranslationState::force, &RotationState::moment);
}

std::vector<double> all_increments(const Model& model, const State& state) {
  return all_column(model, state, &TranslationState::increment, &RotationState::increment);
}

std::vector<double> free_forces(const Model& model, const State& state) {
  return free_column(model, state, &TranslationState::force, &RotationState::moment);
}

std::vector<double> free_velocities(const Model& model, const State& state) {
  return free_column(model, state, &TranslationState::velocity, &RotationState::spin);
}

std::vector<double> free_velocities_before(const Model& model, const State& state) {
  return free_column(model, state, &TranslationState::velocity_before, &RotationState::spin_before);
}

std::vector<double> free_increments(const Model& model, const State& state) {
  return free_column(model, state, &TranslationState::increment, &RotationState::increment);
}

std::vector<double> inverse_masses(const Model& model, const State& state) {
  std::vector<double> column;
  visit_tables([&](BodyTable table) {
    const Field<double>& mass = translation_of(state, table).mass;
    const Field<double>& inertia = rotation_of(state, table).inertia;
    const Field<Vector>& free = free_of(model, table);
    const Field<double>& rotation_free = rotation_free_of(model, table);
    append(
        table, mass.size(), [&](std::size_t i) { return (1.0 / mass[i]) * free[i]; },
        [&](std::size_t i) { return rotation_free[i] * (1.0 / inertia[i]); }, column);
  });
  return column;
}

void move_bodies(const std::vector<double>& motion, State& state) {
  std::size_t next = 0;
  visit_tables([&](BodyTable table) {
    TranslationState& bodies = translation_of(state, table);
    RotationState& rotation = rotation_of(state, table);
    for (std::size_t i = 0; i < bodies.displacement.size(); ++i) {
      Vector part;
      for (int axis = 0; axis < dimension; ++axis) set_component(part, axis, motion[next++]);
      bodies.displacement[i] += part;
      bodies.increment[i] += part;
      if (table == BodyTable::node) continue;
      rotation.rotation[i] += motion[next];
      rotation.increment[i] += motion[next++];
    }
  });
}

void set_displacements(const std::vector<double>& places, State& state) {
  std::size_t next = 0;
  visit_tables([&](BodyTable table) {
    TranslationState& bodies = translation_of(state, table);
    for (std::size_t i = 0; i < bodies.displacement.size(); ++i) {
      for (int axis = 0; axis < dimension; ++axis) set_component(bodies.displacement[i], axis, places[next++]);
      if (table != BodyTable::node) rotation_of(state, table).rotation[i] = places[next++];
    }
  });
}

void set_free_velocities(const Model& model, const std::vector<double>& velocities, State& state) {
  std::size_t next = 0;
  visit_tables([&](BodyTable table) {
    TranslationState& bodies = translation_of(state, table);
    RotationState& rotation = rotation_of(state, table);
    const Field<Vector>& free = free_of(model, table);
    const Field<double>& rotation_free = rotation_free_of(model, table);
    for (std::size_t i = 0; i < bodies.velocity.size(); ++i) {
      bodies.velocity_before[i] = bodies.velocity[i];
      for (int axis = 0; axis < dimension; ++axis, ++next) {
        if (component(free[i], axis) != 0.0) set_component(bodies.velocity[i], axis, velocities[next]);
      }
      if (table == BodyTable::node) continue;
      rotation.spin_before[i] = rotation.spin[i];
      if (rotation_free[i] != 0.0) rotation.spin[i] = velocities[next];
      ++next;
    }
  });
}

double prescribed_kinetic_energy(const Model& model, const State& state) {
  double energy = 0.0;
  visit_tables([&](BodyTable table) {
    energy += held_kinetic_energy(translation_of(state, table), free_of(model, table));
    if (table == BodyTable::node) return;
    energy += held_kinetic_energy(rotation_of(state, table), rotation_free_of(model, table));
  });
  return energy;
}

}  // namespace ligament
