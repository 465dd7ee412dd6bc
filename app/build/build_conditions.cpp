#include "build/build_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "build/build_schedules.hpp"
#include "build/select_bodies.hpp"

namespace ligament {
namespace {

/// Axis of a translation, or `dimension` for the rotation.
int axis_of(const std::string& name) { return name == "x" ? 0 : name == "y" ? 1 : dimension; }

auto key_of(const PrescribedFreedom& freedom) { return std::tuple(freedom.body, freedom.row, freedom.axis); }

void add_freedoms(const Model& model, const SelectedBodies& bodies, PrescribedFreedom freedom,
                  std::vector<PrescribedFreedom>& freedoms) {
  const auto add = [&](BodyTable table, Index row) {
    freedom.body = table;
    freedom.row = row;
    freedoms.push_back(freedom);
  };
  const bool is_rotation = freedom.axis == dimension;
  for (const Index row : bodies.nodes) {
    if (!is_rotation) add(BodyTable::node, row);
  }
  for (const Index row : bodies.particles) add(BodyTable::particle, row);
  for (const Index row : bodies.beam_nodes) add(BodyTable::beam_node, row);
  for (const Index row : bodies.platens) {
    const Platen& platen = model.platens[row];
    add(BodyTable::beam_node, is_rotation ? platen.rotation : platen.translation);
  }
}

void check_rotation(Case& input, const SupportTable& table, const TableView& view, const SelectedBodies& bodies) {
  const bool asks_for_rotation = std::find(table.fix.begin(), table.fix.end(), "rotation") != table.fix.end();
  if (!asks_for_rotation || bodies.nodes.empty() || !bodies.particles.empty() || !bodies.platens.empty()) return;
  input.file.add_error(
      input.file.position(view, "fix"),
      fmt::format("nodes do not rotate {}: hold 'x' or 'y' of several; 'rotation' is for particles", view.where()));
}

/// Walls that a motion drives are neither pushed nor held otherwise.
void check_is_free(Case& input, const Model& model, const BodySelection& selection, const TableView& view) {
  for (const std::string& name : selection.walls) {
    const auto wall = std::find_if(model.walls.begin(), model.walls.end(),
                                   [&](const Wall& candidate) { return candidate.name == name; });
    if (wall == model.walls.end()) continue;
    if (model.platen_of_wall(static_cast<std::size_t>(wall - model.walls.begin())) != nullptr) continue;
    input.file.add_error(input.file.position(view, "walls"),
                         fmt::format("wall '{}' is driven by motion {}: forces and supports are for walls with "
                                     "driven_by = \"force\"",
                                     name, view.where()));
  }
}

/// The freedom with the same key; null if it is not prescribed yet.
PrescribedFreedom* find_freedom(std::vector<PrescribedFreedom>& freedoms, const PrescribedFreedom& wanted) {
  const auto found = std::find_if(freedoms.begin(), freedoms.end(),
                                  [&](const PrescribedFreedom& other) { return key_of(other) == key_of(wanted); });
  return found == freedoms.end() ? nullptr : &*found;
}

/// Two tables that prescribe one freedom in one stage cannot both have their way; supports that repeat each other can.
bool is_in_conflict(const PrescribedFreedom& known, std::int64_t stage) {
  return known.motions.empty() || std::any_of(known.motions.begin(), known.motions.end(),
                                              [&](const StageVelocity& motion) { return motion.stage == stage; });
}

std::vector<PrescribedFreedom> support_freedoms(Case& input, const Model& model) {
  std::vector<PrescribedFreedom> freedoms;
  for (const auto& [table, view] : input.supports) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    check_rotation(input, table, view, bodies);
    check_is_free(input, model, table.bodies, view);
    for (const std::string& name : table.fix) add_freedoms(model, bodies, {.axis = axis_of(name)}, freedoms);
  }
  std::sort(freedoms.begin(), freedoms.end(), [](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
  const auto is_same = [](const auto& a, const auto& b) { return key_of(a) == key_of(b); };
  freedoms.erase(std::unique(freedoms.begin(), freedoms.end(), is_same), freedoms.end());
  return freedoms;
}

/// The velocity that a motion asks for; a displacement is made until it stops, the rise included.
StageVelocity velocity_of(Case& input, const MotionTable& table, const TableView& view) {
  StageVelocity motion{.stage = table.stage,
                       .velocity = table.velocity.value_or(0.0),
                       .rise_time = table.rise_time,
                       .stop_time = table.stop_time.value_or(-1.0)};
  if (table.velocity.has_value() + table.displacement.has_value() + table.schedule.is_given != 1) {
    input.file.add_error(input.file.position(view),
                         fmt::format("give one of 'velocity', 'displacement' and 'schedule' {}", view.where()));
  } else if (table.schedule.is_given) {
    motion.schedule = build_schedule(input, table, view);
  } else if (table.displacement) {
    const double time = motion.stop_time - 0.5 * motion.rise_time;
    if (!(motion.stop_time > 0.0 && motion.rise_time <= motion.stop_time)) {
      input.file.add_error(input.file.position(view, "displacement"),
                           fmt::format("'displacement' needs a 'stop_time' after the 'rise_time' {}", view.where()));
    } else {
      motion.velocity = *table.displacement / time;
    }
  }
  return motion;
}

/// Takes note that loads or motions of a stage change their course at a time (s).
void add_corner(std::int64_t stage, double time, Conditions& conditions) {
  const auto row = static_cast<std::size_t>(stage - 1);
  if (conditions.corners.size() <= row) conditions.corners.resize(row + 1, {0.0});
  std::vector<double>& corners = conditions.corners[row];
  const auto place = std::lower_bound(corners.begin(), corners.end(), time);
  if (place == corners.end() || *place != time) corners.insert(place, time);
}

void add_corners(std::int64_t stage, const PiecewiseLinear& schedule, Conditions& conditions) {
  for (const double time : schedule.times) add_corner(stage, time, conditions);
}

void add_motion(Case& input, const Model& model, const MotionTable& table, const StageVelocity& motion,
                const TableView& view, Conditions& conditions) {
  std::vector<PrescribedFreedom> moved;
  const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
  add_freedoms(model, bodies, {.axis = axis_of(table.direction), .motions = {motion}}, moved);
  bool has_conflict = false;
  for (const PrescribedFreedom& freedom : moved) {
    PrescribedFreedom* known = find_freedom(conditions.freedoms, freedom);
    if (known == nullptr) {
      conditions.freedoms.push_back(freedom);
    } else if (is_in_conflict(*known, table.stage)) {
      has_conflict = true;
    } else {
      known->motions.push_back(freedom.motions.front());
    }
  }
  if (!has_conflict) return;
  input.file.add_error(
      input.file.position(view),
      fmt::format("a freedom is prescribed twice {}: another table holds or moves it too; take it out of one of them",
                  view.where()));
}

void add_motions(Case& input, const Model& model, Conditions& conditions) {
  for (const auto& [table, view] : input.motions) {
    const StageVelocity motion = velocity_of(input, table, view);
    add_motion(input, model, table, motion, view, conditions);
    add_corners(table.stage, motion.schedule, conditions);
    if (table.schedule.is_given || table.velocity.value_or(1.0) == 0.0) continue;
    if (table.rise_time > 0.0) add_corner(table.stage, table.rise_time, conditions);
    add_corner(table.stage, table.stop_time.value_or(std::numeric_limits<double>::infinity()), conditions);
    if (!table.stop_time && input.solver.unbalanced_force_ratio) {
      conditions.warnings.push_back(fmt::format(
          "[[motion]] '{}' has no 'stop_time': the run cannot converge and goes on to max_steps", table.name));
    }
  }
}

/// What no motion moves of a wall stands still.
void hold_walls(const Model& model, Conditions& conditions) {
  for (std::size_t wall = 0; wall < model.walls.size(); ++wall) {
    if (model.platen_of_wall(wall) != nullptr) continue;
    for (const Index node : model.wall_nodes(wall)) {
      for (int axis = 0; axis < dimension; ++axis) {
        const PrescribedFreedom held{.body = BodyTable::node, .row = node, .axis = axis};
        if (find_freedom(conditions.freedoms, held) == nullptr) conditions.freedoms.push_back(held);
      }
    }
  }
}

void add_loads(Case& input, const Model& model, Conditions& conditions) {
  for (const auto& [table, view] : input.loads) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    add_corner(table.stage, table.rise_time, conditions);
    check_is_free(input, model, table.bodies, view);
    PointLoad load{.force = to_vector(table.force), .rise_time = table.rise_time, .stage = table.stage};
    if (table.schedule.is_given) load.schedule = build_schedule(input, table, view);
    add_corners(table.stage, load.schedule, conditions);
    const auto add = [&](BodyTable body, Index row) {
      load.body = body;
      load.row = row;
      conditions.loads.push_back(load);
    };
    for (const Index row : bodies.nodes) add(BodyTable::node, row);
    for (const Index row : bodies.particles) add(BodyTable::particle, row);
    for (const Index row : bodies.beam_nodes) add(BodyTable::beam_node, row);
    for (const Index row : bodies.platens) add(BodyTable::beam_node, model.platens[row].translation);
  }
}

void check_stages(Case& input, const Conditions& conditions) {
  const std::vector<double> ends = ends_of_loading(conditions.corners);
  if (ends.size() == 1) return;
  if (!input.solver.unbalanced_force_ratio) {
    input.file.add_error({},
                         "stages of loading need 'unbalanced_force_ratio' in [solver]: a stage ends in equilibrium");
  }
  for (std::size_t stage = 0; stage + 1 < ends.size(); ++stage) {
    if (std::isfinite(ends[stage])) continue;
    input.file.add_error({}, fmt::format("stage {} never ends: one of its [[motion]] has no 'stop_time'", stage + 1));
  }
}

}  // namespace

std::vector<double> ends_of_loading(const std::vector<std::vector<double>>& corners) {
  std::vector<double> ends;
  for (const std::vector<double>& of_stage : corners) ends.push_back(of_stage.back());
  return ends;
}

Conditions build_conditions(Case& input, const Model& model) {
  Conditions conditions;
  conditions.freedoms = support_freedoms(input, model);
  add_motions(input, model, conditions);
  hold_walls(model, conditions);
  add_loads(input, model, conditions);
  check_stages(input, conditions);
  return conditions;
}

}  // namespace ligament
