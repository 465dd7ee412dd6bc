#include "build/build_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "build/select_bodies.hpp"

namespace ligament {
namespace {

/// Axis of a translation, or `dimension` for the rotation.
int axis_of(const std::string& name) { return name == "x" ? 0 : name == "y" ? 1 : dimension; }

auto key_of(const PrescribedFreedom& freedom) { return std::tuple(freedom.body, freedom.row, freedom.axis); }

void add_freedoms(const SelectedBodies& bodies, PrescribedFreedom freedom, std::vector<PrescribedFreedom>& freedoms) {
  if (freedom.axis < dimension) {
    freedom.body = PrescribedFreedom::Body::node;
    for (const Index row : bodies.nodes) {
      freedom.row = row;
      freedoms.push_back(freedom);
    }
  }
  freedom.body = PrescribedFreedom::Body::particle;
  for (const Index row : bodies.particles) {
    freedom.row = row;
    freedoms.push_back(freedom);
  }
}

void check_rotation(Case& input, const SupportTable& table, const TableView& view, const SelectedBodies& bodies) {
  const bool asks_for_rotation = std::find(table.fix.begin(), table.fix.end(), "rotation") != table.fix.end();
  if (!asks_for_rotation || bodies.nodes.empty() || !bodies.particles.empty()) return;
  input.file.add_error(
      input.file.position(view, "fix"),
      fmt::format("nodes do not rotate {}: hold 'x' or 'y' of several; 'rotation' is for particles", view.where()));
}

/// Two tables that prescribe one freedom cannot both have their way; supports that repeat each other can.
void check_conflicts(Case& input, const TableView& view, const std::vector<PrescribedFreedom>& earlier,
                     const std::vector<PrescribedFreedom>& later) {
  const bool is_taken = std::any_of(later.begin(), later.end(), [&](const PrescribedFreedom& a) {
    return std::any_of(earlier.begin(), earlier.end(), [&](const auto& b) { return key_of(a) == key_of(b); });
  });
  if (!is_taken) return;
  input.file.add_error(
      input.file.position(view),
      fmt::format("a freedom is prescribed twice {}: another table holds or moves it too; take it out of one of them",
                  view.where()));
}

std::vector<PrescribedFreedom> support_freedoms(Case& input, const Model& model) {
  std::vector<PrescribedFreedom> freedoms;
  for (const auto& [table, view] : input.supports) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    check_rotation(input, table, view, bodies);
    for (const std::string& name : table.fix) add_freedoms(bodies, {.axis = axis_of(name)}, freedoms);
  }
  std::sort(freedoms.begin(), freedoms.end(), [](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
  const auto is_same = [](const auto& a, const auto& b) { return key_of(a) == key_of(b); };
  freedoms.erase(std::unique(freedoms.begin(), freedoms.end(), is_same), freedoms.end());
  return freedoms;
}

void add_motions(Case& input, const Model& model, Conditions& conditions) {
  for (const auto& [table, view] : input.motions) {
    std::vector<PrescribedFreedom> moved;
    add_freedoms(select_bodies(model, table.bodies, input.file, view),
                 {.axis = axis_of(table.direction),
                  .velocity = table.velocity,
                  .rise_time = table.rise_time,
                  .stop_time = table.stop_time.value_or(-1.0)},
                 moved);
    check_conflicts(input, view, conditions.freedoms, moved);
    conditions.freedoms.insert(conditions.freedoms.end(), moved.begin(), moved.end());
    if (table.velocity == 0.0) continue;
    conditions.end_of_loading =
        std::max(conditions.end_of_loading, table.stop_time.value_or(std::numeric_limits<double>::infinity()));
    if (!table.stop_time && input.solver.unbalanced_force_ratio) {
      conditions.warnings.push_back(fmt::format(
          "[[motion]] '{}' has no 'stop_time': the run cannot converge and goes on to max_steps", table.name));
    }
  }
}

void add_loads(Case& input, const Model& model, Conditions& conditions) {
  for (const auto& [table, view] : input.loads) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    conditions.end_of_loading = std::max(conditions.end_of_loading, table.rise_time);
    PointLoad load{.force = to_vector(table.force), .rise_time = table.rise_time};
    for (const Index row : bodies.nodes) {
      load.row = row;
      conditions.loads.push_back(load);
    }
    load.body = PointLoad::Body::particle;
    for (const Index row : bodies.particles) {
      load.row = row;
      conditions.loads.push_back(load);
    }
  }
}

}  // namespace

Conditions build_conditions(Case& input, const Model& model) {
  Conditions conditions;
  conditions.freedoms = support_freedoms(input, model);
  add_motions(input, model, conditions);
  add_loads(input, model, conditions);
  return conditions;
}

}  // namespace ligament
