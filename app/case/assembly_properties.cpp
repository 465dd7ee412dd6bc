#include "case/assembly_properties.hpp"

#include <fmt/format.h>

namespace ligament {
namespace {

/// Columns of the gauges that set_up_assembly_properties() makes.
enum GaugeColumn { left, right, bottom, top, stress_xx, stress_yy, strain_xx, strain_yy, n_columns };

constexpr std::size_t n_stages = 2;

/// Normal components along x and y.
struct Pair {
  double x = 0.0;
  double y = 0.0;
};

/// ε = compliance · σ from two pairs of either: the stages' increments.
struct Increments {
  std::array<Pair, n_stages> stress;
  std::array<Pair, n_stages> strain;
};

AssemblyProperties properties_of(const Increments& increments) {
  const auto& [s1, s2] = increments.stress;
  const auto& [e1, e2] = increments.strain;
  const double determinant = s1.x * s2.y - s2.x * s1.y;
  const double xx = (e1.x * s2.y - e2.x * s1.y) / determinant;
  const double xy = (e2.x * s1.x - e1.x * s2.x) / determinant;
  const double yx = (e1.y * s2.y - e2.y * s1.y) / determinant;
  const double yy = (e2.y * s1.x - e1.y * s2.x) / determinant;
  return {.young_modulus_x = 1.0 / xx,
          .young_modulus_y = 1.0 / yy,
          .poisson_ratio_x = -yx / xx,
          .poisson_ratio_y = -xy / yy};
}

/// Change of a reading in a stage, counted from 0.
double increment(const std::vector<double>& readings, std::size_t stage, GaugeColumn column) {
  const double before = stage == 0 ? 0.0 : readings[(stage - 1) * n_columns + column];
  return readings[stage * n_columns + column] - before;
}

using Place = std::array<double, 2>;

void add_wall(Case& input, const char* name, const Place& from, const Place& to, const TableView& view) {
  input.walls.push_back({{.name = name, .from = from, .to = to, .contact = WallContact::tied}, view});
}

void add_motion(Case& input, const char* wall, const char* direction, double displacement, std::int64_t stage,
                const TableView& view) {
  MotionTable motion;
  motion.name = fmt::format("compression_{}", direction);
  motion.bodies.walls = {wall};
  motion.direction = direction;
  motion.displacement = displacement;
  motion.stop_time = input.properties.loading_time;
  motion.stage = stage;
  input.motions.push_back({std::move(motion), view});
}

void add_reaction(Case& input, const char* wall, const char* direction, const TableView& view) {
  GaugeTable gauge;
  gauge.name = fmt::format("force_{}", wall);
  gauge.reaction.is_given = true;
  gauge.reaction.wall = wall;
  gauge.reaction.direction = direction;
  input.gauges.push_back({std::move(gauge), view});
}

void add_region(Case& input, GaugeRegion GaugeTable::*quantity, const char* name, const char* component,
                const ZoneTable& zone, const TableView& view) {
  GaugeTable gauge;
  gauge.name = name;
  GaugeRegion& region = gauge.*quantity;
  region.is_given = true;
  region.component = component;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double margin = input.properties.margin * (zone.to[axis] - zone.from[axis]);
    region.from[axis] = zone.from[axis] + margin;
    region.to[axis] = zone.to[axis] - margin;
  }
  input.gauges.push_back({std::move(gauge), view});
}

/// The test sets its own loads; others would spoil it.
void refuse_other_tables(Case& input) {
  const auto refuse = [&](const auto& tables, const char* name) {
    if (tables.empty()) return;
    input.file.add_error(
        input.file.position(tables.front().view),
        fmt::format("a case of the kind \"assembly_properties\" has no [[{}]]: the test sets its own", name));
  };
  refuse(input.notches, "notch");
  refuse(input.walls, "wall");
  refuse(input.supports, "support");
  refuse(input.motions, "motion");
  refuse(input.loads, "load");
  refuse(input.gauges, "gauge");
  if (input.mesh) {
    input.file.add_error(input.file.position(input.mesh->view),
                         "a case of the kind \"assembly_properties\" has no [mesh]: particles alone are tested");
  }
  if (input.zones.size() != 1) {
    input.file.add_error({},
                         fmt::format("a case of the kind \"assembly_properties\" has one [[zone]], but there are {}",
                                     input.zones.size()));
  }
}

}  // namespace

void set_up_assembly_properties(Case& input) {
  refuse_other_tables(input);
  if (input.file.has_errors()) return;
  const auto& [zone, view] = input.zones.front();
  const auto& [x0, y0] = zone.from;
  const auto& [x1, y1] = zone.to;
  add_wall(input, "left", {x0, y0}, {x0, y1}, view);
  add_wall(input, "right", {x1, y0}, {x1, y1}, view);
  add_wall(input, "bottom", {x0, y0}, {x1, y0}, view);
  add_wall(input, "top", {x0, y1}, {x1, y1}, view);
  add_motion(input, "right", "x", -input.properties.strain * (x1 - x0), 1, view);
  add_motion(input, "top", "y", -input.properties.strain * (y1 - y0), 2, view);
  add_reaction(input, "left", "x", view);
  add_reaction(input, "right", "x", view);
  add_reaction(input, "bottom", "y", view);
  add_reaction(input, "top", "y", view);
  add_region(input, &GaugeTable::stress, "stress_xx", "xx", zone, view);
  add_region(input, &GaugeTable::stress, "stress_yy", "yy", zone, view);
  add_region(input, &GaugeTable::strain, "strain_xx", "xx", zone, view);
  add_region(input, &GaugeTable::strain, "strain_yy", "yy", zone, view);
}

AssemblyProperties wall_properties(const Case& input, const std::vector<double>& readings) {
  const ZoneTable& zone = input.zones.front().table;
  const double area_x = (zone.to[1] - zone.from[1]) * input.problem.thickness;
  const double area_y = (zone.to[0] - zone.from[0]) * input.problem.thickness;
  Increments increments;
  for (std::size_t stage = 0; stage < n_stages; ++stage) {
    const auto force = [&](GaugeColumn low, GaugeColumn high) {
      return 0.5 * (increment(readings, stage, high) - increment(readings, stage, low));
    };
    increments.stress[stage] = {force(left, right) / area_x, force(bottom, top) / area_y};
  }
  increments.strain = {Pair{-input.properties.strain, 0.0}, Pair{0.0, -input.properties.strain}};
  return properties_of(increments);
}

AssemblyProperties region_properties(const std::vector<double>& readings) {
  Increments increments;
  for (std::size_t stage = 0; stage < n_stages; ++stage) {
    increments.stress[stage] = {increment(readings, stage, stress_xx), increment(readings, stage, stress_yy)};
    increments.strain[stage] = {increment(readings, stage, strain_xx), increment(readings, stage, strain_yy)};
  }
  return properties_of(increments);
}

}  // namespace ligament
