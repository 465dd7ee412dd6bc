#include "build/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "build/check_loading.hpp"
#include "contact/contact_stiffness.hpp"
#include "core/closest_name.hpp"
#include "mesh/structured_mesh.hpp"

namespace ligament {
namespace {

const MaterialTable* find_material(const Case& input, const std::string& name) {
  const auto found = std::find_if(input.materials.begin(), input.materials.end(),
                                  [&](const auto& material) { return material.table.name == name; });
  return found == input.materials.end() ? nullptr : &found->table;
}

void check_material_name(Case& input, const TableView& view, const char* key, const std::string& name) {
  if (find_material(input, name) != nullptr) return;
  std::vector<std::string> names;
  for (const auto& material : input.materials) names.push_back(material.table.name);
  input.file.add_error(input.file.position(view, key),
                       fmt::format("there is no material '{}' {} (there are: {}){}", name, view.where(),
                                   names.empty() ? "none" : quoted_list(names), did_you_mean(name, names)));
}

/// A material whose contacts take their stiffness from Eq. (34).
void check_formula(Case& input, const TableView& view, const std::string& name) {
  const MaterialTable* material = find_material(input, name);
  if (material == nullptr || material->stiffness != StiffnessFormula::hexagonal) return;
  const double limit = poisson_limit_of_hexagonal(input.problem.plane);
  if (material->poisson_ratio < limit) return;
  const auto place = std::find_if(input.materials.begin(), input.materials.end(),
                                  [&](const auto& other) { return other.table.name == name; });
  input.file.add_error(
      input.file.position(place->view, "poisson_ratio"),
      fmt::format("stiffness = \"hexagonal\" needs 'poisson_ratio' below {:.4g}, but it is {} {} (used {}); take "
                  "stiffness = \"plane\"",
                  limit, material->poisson_ratio, place->view.where(), view.where()));
}

void check_density(Case& input, const std::string& name) {
  const MaterialTable* material = find_material(input, name);
  const bool has_gravity = input.problem.gravity != std::array<double, 2>{};
  const bool is_needed = input.solver.time_step.masses == Masses::real || has_gravity;
  if (material == nullptr || material->density || !is_needed) return;
  const auto place = std::find_if(input.materials.begin(), input.materials.end(),
                                  [&](const auto& other) { return other.table.name == name; });
  input.file.add_error(input.file.position(place->view),
                       fmt::format("missing key 'density' {}: {} needs it", place->view.where(),
                                   has_gravity ? "gravity" : "masses = \"real\""));
}

bool ascend(const std::vector<double>& lines) {
  return std::adjacent_find(lines.begin(), lines.end(), std::greater_equal<>()) == lines.end();
}

void check_lines(Case& input, const char* key, const std::vector<double>& lines) {
  if (ascend(lines)) return;
  const TableView& view = input.mesh->view;
  input.file.add_error(input.file.position(view, key), fmt::format("'{}' must ascend {}", key, view.where()));
}

/// A grid that no machine of today could step is better told than tried.
void check_mesh_size(Case& input) {
  constexpr double most = 2e7;
  constexpr double bytes_per_element = 700.0;  // with its nodes
  const MeshTable& mesh = input.mesh->table;
  const double count = static_cast<double>(mesh.x.size() - 1) * static_cast<double>(mesh.y.size() - 1);
  if (count <= most) return;
  input.file.add_error(input.file.position(input.mesh->view),
                       fmt::format("this would make {:.3g} elements, which take some {:.3g} GB, and the limit is "
                                   "{:.0g} elements: fewer grid lines would do",
                                   count, 1e-9 * bytes_per_element * count, most));
}

void check_mesh(Case& input) {
  if (!input.mesh) return;
  const MeshTable& mesh = input.mesh->table;
  check_lines(input, "x", mesh.x);
  check_lines(input, "y", mesh.y);
  check_material_name(input, input.mesh->view, "material", mesh.material);
  check_density(input, mesh.material);
  check_mesh_size(input);
}

void check_beams(Case& input) {
  for (const auto& [table, view] : input.beams) {
    check_material_name(input, view, "material", table.material);
    check_density(input, table.material);
  }
}

bool overlap(const ZoneTable& a, const ZoneTable& b) {
  bool all = true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double tolerance = 1e-9 * (a.to[axis] - a.from[axis]);
    all = all && a.from[axis] < b.to[axis] - tolerance && b.from[axis] < a.to[axis] - tolerance;
  }
  return all;
}

void check_zone_place(Case& input, const Read<ZoneTable>& zone) {
  const auto& [table, view] = zone;
  if (!(table.from[0] < table.to[0] && table.from[1] < table.to[1])) {
    input.file.add_error(input.file.position(view, "to"),
                         fmt::format("'to' must lie above and right of 'from' {}", view.where()));
  } else if (input.mesh && ascend(input.mesh->table.x) && ascend(input.mesh->table.y) &&
             !is_block_of_grid({input.mesh->table.x, input.mesh->table.y},
                               {to_vector(table.from), to_vector(table.to)})) {
    input.file.add_error(
        input.file.position(view, "from"),
        fmt::format("the zone does not replace whole elements {}: its border must follow lines of the mesh",
                    view.where()));
  }
}

void check_zones(Case& input) {
  for (std::size_t i = 0; i < input.zones.size(); ++i) {
    const auto& [table, view] = input.zones[i];
    check_zone_place(input, input.zones[i]);
    const std::string& interface_material = table.interface_material.value_or(table.material);
    check_material_name(input, view, "material", table.material);
    if (table.interface_material) check_material_name(input, view, "interface_material", interface_material);
    check_formula(input, view, table.material);
    if (input.mesh) check_formula(input, view, interface_material);
    check_density(input, table.material);
    for (std::size_t j = 0; j < i; ++j) {
      if (!overlap(input.zones[j].table, table)) continue;
      input.file.add_error(input.file.position(view, "from"),
                           fmt::format("zone '{}' overlaps zone '{}': zones may share a border, no more", table.name,
                                       input.zones[j].table.name));
    }
  }
}

}  // namespace

void check_case(Case& input) {
  check_mesh(input);
  check_zones(input);
  check_beams(input);
  check_loading(input);
  if (!input.mesh && input.zones.empty() && input.beams.empty()) {
    input.file.add_error({}, "there is nothing to calculate: give a [mesh], a [[zone]], or both");
  }
  input.file.throw_collected_errors();
}

}  // namespace ligament
