#include "build/select_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/closest_name.hpp"

namespace ligament {
namespace {

/// Rows from `begin` to `end` of bodies on the lines given; coordinates count as equal within a billionth of the
/// structure.
std::vector<Index> rows_at(const Field<Vector>& positions, std::size_t begin, std::size_t end,
                           const BodySelection& selection) {
  double size = 0.0;
  for (const Vector& position : positions) size = std::max(size, largest_component(position));
  const auto matches = [&](const std::optional<double>& wanted, double position) {
    return !wanted || std::abs(*wanted - position) <= 1e-9 * size;
  };
  std::vector<Index> rows;
  for (std::size_t i = begin; i < end; ++i) {
    if (matches(selection.x, component(positions[i], 0)) && matches(selection.y, component(positions[i], 1))) {
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

/// Row of what has this name; -1, and an error of the case file, if there is none.
template <class Table>
Index find_named(const std::vector<Table>& tables, const char* kind, const std::string& name, CaseFile& file,
                 const TableView& view, const char* key) {
  std::vector<std::string> names;
  for (const Table& table : tables) names.push_back(table.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Index>(found - names.begin());
  file.add_error(file.position(view, key),
                 fmt::format("there is no {} '{}' {} (there are: {}){}", kind, name, view.where(),
                             names.empty() ? "none" : quoted_list(names), did_you_mean(name, names)));
  return -1;
}

void add_beam_nodes(const Model& model, const BodySelection& selection, CaseFile& file, const TableView& view,
                    std::vector<Index>& rows) {
  const Beam* beam = find_beam(model, *selection.beam, file, view, "beam");
  if (beam == nullptr) return;
  if (!selection.particles.empty()) {
    file.add_error(file.position(view, "particles"), fmt::format("a beam has no particles {}", view.where()));
  }
  for (const std::int64_t number : selection.nodes) {
    if (number <= beam->n_nodes) {
      rows.push_back(beam->first_node + static_cast<Index>(number - 1));
    } else {
      file.add_error(file.position(view, "nodes"), fmt::format("there is no node {} {}: beam '{}' has {}", number,
                                                               view.where(), beam->name, beam->n_nodes));
    }
  }
  if (!selection.nodes.empty()) return;
  rows = rows_at(model.beam_nodes.position, beam->first_node, beam->first_node + beam->n_nodes, selection);
  if (rows.empty()) {
    file.add_error(file.position(view, "at"),
                   fmt::format("beam '{}' has no node at this place {}", beam->name, view.where()));
  }
}

/// Walls that are moved are their ends; platens are themselves.
void add_walls(const Model& model, const BodySelection& selection, CaseFile& file, const TableView& view,
               SelectedBodies& bodies) {
  for (const std::string& name : selection.walls) {
    const auto wall = find_wall(model, name, file, view, "walls");
    if (!wall) continue;
    if (const Platen* platen = model.platen_of_wall(*wall); platen != nullptr) {
      bodies.platens.push_back(static_cast<Index>(platen - model.platens.data()));
    } else {
      for (const Index node : model.wall_nodes(*wall)) bodies.nodes.push_back(node);
    }
  }
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

std::optional<std::size_t> find_wall(const Model& model, const std::string& name, CaseFile& file, const TableView& view,
                                     const char* key) {
  const Index row = find_named(model.walls, "wall", name, file, view, key);
  return row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row));
}

const Beam* find_beam(const Model& model, const std::string& name, CaseFile& file, const TableView& view,
                      const char* key) {
  const Index row = find_named(model.beams, "beam", name, file, view, key);
  return row < 0 ? nullptr : &model.beams[row];
}

SelectedBodies select_bodies(const Model& model, const BodySelection& selection, CaseFile& file,
                             const TableView& view) {
  SelectedBodies bodies;
  const bool by_place = selection.x || selection.y;
  if (selection.beam) {
    add_beam_nodes(model, selection, file, view, bodies.beam_nodes);
    add_walls(model, selection, file, view, bodies);
    return bodies;
  }
  if (!by_place && selection.nodes.empty() && selection.particles.empty() && selection.walls.empty()) {
    file.add_error(file.position(view),
                   fmt::format("no bodies {}: give 'at', 'nodes', 'particles', 'beam' or 'walls'", view.where()));
  }
  if (by_place) {
    bodies.nodes = rows_at(model.nodes.position, 0, model.n_mesh_nodes(), selection);
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
  add_walls(model, selection, file, view, bodies);
  sort_and_drop_repeats(bodies.nodes);
  sort_and_drop_repeats(bodies.particles);
  return bodies;
}

}  // namespace ligament
