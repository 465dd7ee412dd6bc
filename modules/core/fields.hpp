#pragma once

#include <concepts>
#include <string>
#include <type_traits>

#include "core/state.hpp"

/// THE list of the fields of State. Restart, hash, comparison and the carrying-over of contacts are visitors of it.
/// Each function opens with a structured binding of the whole table, so that a forgotten member does not compile.
namespace ligament {

/// Whether a field decides how the run goes on, or only samples it. The state hash covers what decides.
enum class FieldRole { physics, sampled };

template <class T, class Table>
concept TableOf = std::same_as<std::remove_const_t<T>, Table>;

template <TableOf<Clock> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [step, time, time_step, time_step_before] = table;
  visit("step", step, FieldRole::physics);
  visit("time", time, FieldRole::physics);
  visit("time_step", time_step, FieldRole::physics);
  visit("time_step_before", time_step_before, FieldRole::physics);
}

template <TableOf<TranslationState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [displacement, increment, velocity_before, velocity, force, mass] = table;
  visit("displacement", displacement, FieldRole::physics);
  visit("increment", increment, FieldRole::physics);
  visit("velocity_before", velocity_before, FieldRole::physics);
  visit("velocity", velocity, FieldRole::physics);
  visit("force", force, FieldRole::physics);
  visit("mass", mass, FieldRole::physics);
}

template <TableOf<RotationState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [rotation, increment, spin_before, spin, moment, inertia] = table;
  visit("rotation", rotation, FieldRole::physics);
  visit("rotation_increment", increment, FieldRole::physics);
  visit("spin_before", spin_before, FieldRole::physics);
  visit("spin", spin, FieldRole::physics);
  visit("moment", moment, FieldRole::physics);
  visit("inertia", inertia, FieldRole::physics);
}

template <TableOf<TurningState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [translation, rotation] = table;
  visit_fields(translation, visit);
  visit_fields(rotation, visit);
}

template <TableOf<NodeState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [translation] = table;
  visit_fields(translation, visit);
}

template <TableOf<PlatenState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [force] = table;
  visit("force", force, FieldRole::physics);
}

/// The fields of a contact table that have one row per contact.
template <TableOf<ContactTable> Table, class Visitor>
void visit_rows(Table& table, Visitor&& visit) {
  auto& [law, first, second, rest_distance, initial_gap, normal_stiffness, shear_stiffness, area, opening,
         shear_displacement, normal_force, shear_force, bond, law_begin, history] = table;
  static_cast<void>(law_begin);
  static_cast<void>(history);
  visit("law", law, FieldRole::physics);
  visit("first", first, FieldRole::physics);
  visit("second", second, FieldRole::physics);
  visit("rest_distance", rest_distance, FieldRole::physics);
  visit("initial_gap", initial_gap, FieldRole::physics);
  visit("normal_stiffness", normal_stiffness, FieldRole::physics);
  visit("shear_stiffness", shear_stiffness, FieldRole::physics);
  visit("area", area, FieldRole::physics);
  visit("opening", opening, FieldRole::physics);
  visit("shear_displacement", shear_displacement, FieldRole::physics);
  visit("normal_force", normal_force, FieldRole::physics);
  visit("shear_force", shear_force, FieldRole::physics);
  visit("bond", bond, FieldRole::physics);
}

template <TableOf<ContactTable> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  visit_rows(table, visit);
  visit("law_begin", table.law_begin, FieldRole::physics);
  for (auto& column : table.history) visit("history." + column.name, column.values, FieldRole::physics);
}

template <TableOf<SearchState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [particle_displacement, node_displacement, n_updates] = table;
  visit("particle_displacement", particle_displacement, FieldRole::physics);
  visit("node_displacement", node_displacement, FieldRole::physics);
  visit("n_updates", n_updates, FieldRole::physics);
}

template <TableOf<StageState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [number, begin_step, begin_time, readings, peaks, force_mismatch] = table;
  visit("number", number, FieldRole::physics);
  visit("begin_step", begin_step, FieldRole::physics);
  visit("begin_time", begin_time, FieldRole::physics);
  visit("readings", readings, FieldRole::sampled);
  visit("peaks", peaks, FieldRole::sampled);
  visit("force_mismatch", force_mismatch, FieldRole::sampled);
}

template <TableOf<LoadingState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [step, direction_step, direction, older_step, older_direction, peak_force, gauge_sign, secants, places,
         secants_update, n_evaluations, n_factorisations, n_relaxed, n_without_control] = table;
  visit("step", step, FieldRole::physics);
  visit("direction_step", direction_step, FieldRole::physics);
  visit("direction", direction, FieldRole::physics);
  visit("older_step", older_step, FieldRole::physics);
  visit("older_direction", older_direction, FieldRole::physics);
  visit("peak_force", peak_force, FieldRole::physics);
  visit("gauge_sign", gauge_sign, FieldRole::physics);
  visit("secants", secants, FieldRole::physics);
  visit("places", places, FieldRole::physics);
  visit("secants_update", secants_update, FieldRole::physics);
  visit("n_evaluations", n_evaluations, FieldRole::physics);
  visit("n_factorisations", n_factorisations, FieldRole::physics);
  visit("n_relaxed", n_relaxed, FieldRole::physics);
  visit("n_without_control", n_without_control, FieldRole::physics);
}

template <TableOf<CrackState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [n_tension, n_shear] = table;
  // Bonds break by themselves; whoever watches counts them.
  visit("n_tension", n_tension, FieldRole::sampled);
  visit("n_shear", n_shear, FieldRole::sampled);
}

template <TableOf<RelaxationState> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [damping, particle_force, particle_moment, node_force, beam_force, beam_moment, momentum, force] = table;
  visit("damping", damping, FieldRole::physics);
  visit("particle_force", particle_force, FieldRole::physics);
  visit("particle_moment", particle_moment, FieldRole::physics);
  visit("node_force", node_force, FieldRole::physics);
  visit("beam_force", beam_force, FieldRole::physics);
  visit("beam_moment", beam_moment, FieldRole::physics);
  visit("momentum", momentum, FieldRole::physics);
  visit("force", force, FieldRole::physics);
}

template <TableOf<EnergyLedger> Table, class Visitor>
void visit_fields(Table& table, Visitor&& visit) {
  auto& [names, sums, scale, largest_error] = table;
  // Names follow from the case.
  static_cast<void>(names);
  visit("sums", sums, FieldRole::physics);
  visit("scale", scale, FieldRole::sampled);
  visit("largest_error", largest_error, FieldRole::sampled);
}

/// All fields of the state, as visit(name, field, role), names as "<table>.<field>".
template <TableOf<State> Table, class Visitor>
void visit_fields(Table& state, Visitor&& visit) {
  auto& [clock, particles, nodes, beam_nodes, platens, particle_contacts, facet_contacts, corner_contacts,
         seat_contacts, search, stage, relaxation, loading, cracks, ledger] = state;
  const auto visit_table = [&visit](const std::string& name, auto& table) {
    visit_fields(table, [&](const std::string& field_name, auto& field, FieldRole role) {
      visit(name + "." + field_name, field, role);
    });
  };
  visit_table("clock", clock);
  visit_table("particles", particles);
  visit_table("nodes", nodes);
  visit_table("beam_nodes", beam_nodes);
  visit_table("platens", platens);
  visit_table("particle_contacts", particle_contacts);
  visit_table("facet_contacts", facet_contacts);
  visit_table("corner_contacts", corner_contacts);
  visit_table("seat_contacts", seat_contacts);
  visit_table("search", search);
  visit_table("stage", stage);
  visit_table("relaxation", relaxation);
  visit_table("loading", loading);
  visit_table("cracks", cracks);
  visit_table("ledger", ledger);
}

}  // namespace ligament
