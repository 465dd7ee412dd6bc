#include "build/check_loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/rectangle.hpp"

namespace ligament {
namespace {

/// Whether a wall has points inside a zone that is made smaller on all sides by a part of its size, larger if that is
/// negative.
bool runs_through(const WallTable& wall, const ZoneTable& zone, double part) {
  const Rectangle region{to_vector(zone.from), to_vector(zone.to)};
  const Vector margin = part * region.size();
  return share_inside({region.from + margin, region.to - margin}, to_vector(wall.from), to_vector(wall.to)) > 0.0;
}

/// Rounding of places, over the size of a zone.
constexpr double rounding = 1e-9;

bool is_left_of(const ZoneTable& zone, const WallTable& wall) {
  const Vector centre = 0.5 * (to_vector(zone.from) + to_vector(zone.to));
  return cross(to_vector(wall.to) - to_vector(wall.from), centre - to_vector(wall.from)) > 0.0;
}

/// Facets of walls face one side.
void check_sides(Case& input, const WallTable& wall, const TableView& view) {
  const ZoneTable* first = nullptr;
  for (const auto& zone : input.zones) {
    if (!runs_through(wall, zone.table, -rounding)) continue;
    if (first == nullptr) {
      first = &zone.table;
    } else if (is_left_of(zone.table, wall) != is_left_of(*first, wall)) {
      input.file.add_error(input.file.position(view, "from"),
                           fmt::format("the wall has zone '{}' on one side and zone '{}' on the other {}: it may touch "
                                       "particles on one side only",
                                       first->name, zone.table.name, view.where()));
    }
  }
}

void check_walls(Case& input) {
  for (const Read<WallTable>& wall : input.walls) {
    const auto through = std::find_if(input.zones.begin(), input.zones.end(), [&](const Read<ZoneTable>& zone) {
      return runs_through(wall.table, zone.table, rounding);
    });
    if (through == input.zones.end()) {
      check_sides(input, wall.table, wall.view);
    } else {
      input.file.add_error(input.file.position(wall.view, "from"),
                           fmt::format("the wall runs through zone '{}' {}: it may touch its border, no more",
                                       through->table.name, wall.view.where()));
    }
  }
}

/// A stage without loads or motions would end as it begins; gravity is there from the first one on.
void check_stages(Case& input) {
  std::map<std::int64_t, const TableView*> stages;
  for (const auto& [motion, view] : input.motions) stages.try_emplace(motion.stage, &view);
  for (const auto& [load, view] : input.loads) stages.try_emplace(load.stage, &view);
  std::int64_t before = input.problem.gravity != std::array<double, 2>{} ? 1 : 0;
  for (const auto& [stage, view] : stages) {
    if (stage > before + 1) {
      input.file.add_error(
          input.file.position(*view, "stage"),
          fmt::format("stage {} {} has no stage {} before it: no [[load]] or [[motion]] has that number", stage,
                      view->where(), before + 1));
    }
    before = stage;
  }
}

/// Two-level relaxation makes masses of its own, for steps of 1 s of pseudo-time.
void check_method(Case& input) {
  if (input.solver.method != "two_level_relaxation") return;
  const TableView solver = input.file.table("solver");
  if (input.solver.time_step.masses == Masses::real) {
    input.file.add_error(input.file.position(solver, "masses"),
                         "method = \"two_level_relaxation\" makes its own masses and cannot take masses = \"real\"; "
                         "dynamics is method = \"undamped\"");
  }
  if (input.solver.time_step.time_step != 1.0) {
    input.file.add_error(input.file.position(solver, "time_step"),
                         "method = \"two_level_relaxation\" has steps of 1 s of pseudo-time: leave 'time_step' out");
  }
}

void check_output(Case& input) {
  if (!input.output.transient_every || input.solver.loading) return;
  input.file.add_error(input.file.position(input.file.table("output"), "transient_every"),
                       "'transient_every' is for method = \"quasi_static\" in [solver]: other methods have no states "
                       "between their steps");
}

}  // namespace

void check_loading(Case& input) {
  check_walls(input);
  check_stages(input);
  check_method(input);
  check_output(input);
}

}  // namespace ligament
