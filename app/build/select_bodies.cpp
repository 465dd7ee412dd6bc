#include "build/select_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/closest_name.hpp"

namespace ligament {
namespace {

/// Nodes on the lines given; coordinates count as equal within a billionth of the structure.
std::vector<Index> nodes_at(const Model& model, const BodySelection& selection) {
  double size = 0.0;
  for (const Vector& position : model.nodes.position) size = std::max(size, largest_component(position));
  const auto matches = [&](const std::optional<double>& wanted, double position) {
    return !wanted || std::abs(*wanted - position) <= 1e-9 * size;
  };
  std::vector<Index> rows;
  for (std::size_t i = 0; i < model.n_mesh_nodes(); ++i) {
    const Vector& position = model.nodes.position[i];
    if (matches(selection.x, component(position, 0)) && matches(selection.y, component(position, 1))) {
      rows.push_back(static_cast<Index>(i));
    }
  }
  return rows;
}

void add_by_number(const Field<Index>& ids, const std::vector<std::int64_t>& numbers, const char* kind, const char* key,
                   CaseFile& file, const TableView& view, std::vector<Index>& rows) {
  for (const std::int64_t number : numbers) {
    const Index row = row_of_id(ids, number);
    if (row >= 0) {
      rows.push_back(row);
    } else {
      file.add_error(file.position(view, key),
                     fmt::format("there is no {} {} {}: it is beyond the last one or a zone has replaced it", kind,
                                 number, view.where()));
    }
  }
}

std::vector<std::string> names_of(const std::vector<Wall>& walls) {
  std::vector<std::string> names;
  for (const Wall& wall : walls) names.push_back(wall.name);
  return names;
}

void sort_and_drop_repeats(std::vector<Index>& rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

}  // namespace

Index row_of_id(const Field<Index>& ids, std::int64_t id) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  return found == ids.end() ? -1 : static_cast<Index>(found - ids.begin());
}

std::optional<std::array<Index, 2>> find_wall(const Model& model, const std::string& name, CaseFile& file,
                                              const TableView& view, const char* key) {
  for (std::size_t wall = 0; wall < model.walls.size(); ++wall) {
    if (model.walls[wall].name == name) return model.wall_nodes(wall);
  }
  const std::vector<std::string> names = names_of(model.walls);
  file.add_error(file.position(view, key),
                 fmt::format("there is no wall '{}' {} (there are: {}){}", name, view.where(),
                             names.empty() ? "none" : quoted_list(names), did_you_mean(name, names)));
  return std::nullopt;
}

SelectedBodies select_bodies(const Model& model, const BodySelection& selection, CaseFile& file,
                             const TableView& view) {
  SelectedBodies bodies;
  const bool by_place = selection.x || selection.y;
  if (!by_place && selection.nodes.empty() && selection.particles.empty()) {
    file.add_error(file.position(view), fmt::format("no bodies {}: give 'at', 'nodes' or 'particles'", view.where()));
  }
  if (by_place) {
    bodies.nodes = nodes_at(model, selection);
    if (bodies.nodes.empty()) {
      file.add_error(
          file.position(view, "at"),
          fmt::format(
              "there is no node at this place {}: nodes are where lines of the mesh cross and no zone has replaced "
              "them",
              view.where()));
    }
  }
  add_by_number(model.nodes.id, selection.nodes, "node", "nodes", file, view, bodies.nodes);
  add_by_number(model.particles.id, selection.particles, "particle", "particles", file, view, bodies.particles);
  sort_and_drop_repeats(bodies.nodes);
  sort_and_drop_repeats(bodies.particles);
  return bodies;
}

}  // namespace ligament
