#include "build/watched_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "build/gauge_foot.hpp"
#include "build/select_bodies.hpp"
#include "integrator/platens.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {
namespace {

/// The node or particle nearest to a place.
WatchedBody nearest_body(const Model& model, const Vector& place, int axis) {
  WatchedBody nearest{.axis = axis};
  double least = std::numeric_limits<double>::infinity();
  const auto see = [&](const Vector& position, BodyTable body, std::size_t row) {
    const double distance = norm(position - place);
    if (distance >= least) return;
    least = distance;
    nearest.body = body;
    nearest.row = static_cast<Index>(row);
  };
  for (std::size_t i = 0; i < model.n_mesh_nodes(); ++i) see(model.nodes.position[i], BodyTable::node, i);
  for (std::size_t i = 0; i < model.particles.size(); ++i) see(model.particles.position[i], BodyTable::particle, i);
  return nearest;
}

/// The nodes of the element that holds a place, by their share in its motion; nothing if there is no element. Elements
/// are rectangles along the axes.
std::vector<WatchedBody> nodes_around(const Model& model, const Vector& place, int axis) {
  for (const auto& nodes : model.elements.nodes) {
    const Vector low = model.nodes.position[nodes[0]];
    const Vector high = model.nodes.position[nodes[2]];
    const double x = (place.x - low.x) / (high.x - low.x);
    const double y = (place.y - low.y) / (high.y - low.y);
    // A place on a grid line may lie beside it by rounding.
    constexpr double rounding = 1e-9;
    if (std::min(x, y) < -rounding || std::max(x, y) > 1.0 + rounding) continue;
    return {{BodyTable::node, nodes[0], axis, (1.0 - x) * (1.0 - y)},
            {BodyTable::node, nodes[1], axis, x * (1.0 - y)},
            {BodyTable::node, nodes[2], axis, x * y},
            {BodyTable::node, nodes[3], axis, (1.0 - x) * y}};
  }
  return {};
}

/// What moves with a place: its element, or the particle whose edge is nearest; nothing if it is outside the structure,
/// which is an error of the case file.
std::vector<WatchedBody> bodies_at(Case& input, const Model& model, const Vector& place, int axis,
                                   const TableView& view, const char* key) {
  std::vector<WatchedBody> nodes = nodes_around(model, place, axis);
  if (!nodes.empty()) return nodes;
  const auto gap = [&](Index row) { return norm(model.particles.position[row] - place) - model.particles.radius[row]; };
  Index nearest = 0;
  const auto n_particles = static_cast<Index>(model.particles.size());
  for (Index row = 1; row < n_particles; ++row) {
    if (gap(row) < gap(nearest)) nearest = row;
  }
  // choice: voids of assemblies are smaller than the particles around them.
  if (n_particles > 0 && gap(nearest) <= model.particles.radius[nearest]) return {{BodyTable::particle, nearest, axis}};
  input.file.add_error(input.file.position(view, key), fmt::format("there is no element or particle at ({} m, {} m) {}",
                                                                   place.x, place.y, view.where()));
  return {};
}

std::vector<WatchedBody> node_of_beam(Case& input, const Model& model, const GaugePoint& point, const TableView& view,
                                      const char* key) {
  const Beam* beam = find_beam(model, *point.beam, input.file, view, key);
  if (beam == nullptr) return {};
  const std::int64_t number = point.node.value_or(0);
  if (number >= 1 && number <= beam->n_nodes) {
    return {{BodyTable::beam_node, beam->first_node + static_cast<Index>(number - 1), axis_of(point.direction)}};
  }
  input.file.add_error(input.file.position(view, key),
                       fmt::format("'{}' needs the number of a 'node' of beam '{}', from 1 to {} {}", key, beam->name,
                                   beam->n_nodes, view.where()));
  return {};
}

}  // namespace

double WatchedBody::displacement(const State& state) const {
  return component(translation_of(state, body).displacement[row], axis);
}

double WatchedBody::holding(const Model& model, const State& state) const {
  const Vector force = body == BodyTable::node
                           ? holding_force(model, state, row)
                           : reaction(translation_of(state, body), free_of(model, body), state.clock, row);
  return component(force, axis);
}

Index WatchedBody::freedom(const Model& model) const {
  const FreedomNumbers numbers(model);
  if (body == BodyTable::node) return numbers.node(row, axis);
  return body == BodyTable::particle ? numbers.particle(row, axis) : numbers.beam_node(row, axis);
}

int axis_of(const std::string& direction) { return direction == "y" ? 1 : 0; }

std::vector<WatchedBody> bodies_of_supports(Case& input, const Model& model, const std::vector<std::string>& names,
                                            int axis, const TableView& view, const char* key) {
  std::vector<WatchedBody> bodies;
  for (const std::string& name : names) {
    const auto support = std::find_if(input.supports.begin(), input.supports.end(),
                                      [&](const auto& other) { return other.table.name == name; });
    if (support == input.supports.end()) {
      input.file.add_error(input.file.position(view, key),
                           fmt::format("there is no [[support]] '{}' {}", name, view.where()));
      continue;
    }
    const SelectedBodies selected = select_bodies(model, support->table.bodies, input.file, support->view);
    for (const Index row : selected.nodes) bodies.push_back({BodyTable::node, row, axis});
    for (const Index row : selected.particles) bodies.push_back({BodyTable::particle, row, axis});
    for (const Index row : selected.beam_nodes) bodies.push_back({BodyTable::beam_node, row, axis});
    for (const Index row : selected.platens) {
      bodies.push_back({BodyTable::beam_node, model.platens[row].translation, axis});
    }
  }
  return bodies;
}

std::vector<WatchedBody> find_bodies(Case& input, const Model& model, const GaugePoint& point, const TableView& view,
                                     const char* key) {
  const SourcePosition position = input.file.position(view, key);
  const int n_given = point.node.has_value() + point.particle.has_value() + point.point.has_value() +
                      point.wall.has_value() + !point.supports.empty();
  if (n_given != 1) {
    input.file.add_error(position, fmt::format("'{}' needs one of 'node', 'particle', {}'wall' and 'supports' {}", key,
                                               std::string(key) == "displacement" ? "'point', " : "", view.where()));
    return {};
  }
  if (!point.supports.empty())
    return bodies_of_supports(input, model, point.supports, axis_of(point.direction), view, key);
  if (point.point) return bodies_at(input, model, to_vector(*point.point), axis_of(point.direction), view, key);
  if (point.wall) {
    const auto wall = find_wall(model, *point.wall, input.file, view, key);
    if (!wall) return {};
    const auto nodes = model.wall_nodes(*wall);
    return {{BodyTable::node, nodes[0], axis_of(point.direction)},
            {BodyTable::node, nodes[1], axis_of(point.direction)}};
  }
  if (point.beam) return node_of_beam(input, model, point, view, key);
  const bool is_node = point.node.has_value();
  const std::int64_t number = is_node ? *point.node : *point.particle;
  const Index row = row_of_id(is_node ? model.nodes.id : model.particles.id, number);
  if (row >= 0) return {{is_node ? BodyTable::node : BodyTable::particle, row, axis_of(point.direction)}};
  input.file.add_error(position,
                       fmt::format("there is no {} {} {}: it is beyond the last one or a zone has replaced it",
                                   is_node ? "node" : "particle", number, view.where()));
  return {};
}

std::vector<WatchedBody> bodies_of_end(Case& input, const Model& model, const GaugePair& pair, const Vector& place,
                                       const Vector& other, const TableView& view) {
  const int axis = axis_of(pair.direction);
  if (pair.foot == 0.0) return {nearest_body(model, place, axis)};
  std::vector<WatchedBody> bodies = bodies_under_foot(model, place, other, pair.foot, axis);
  if (!bodies.empty()) return bodies;
  input.file.add_error(input.file.position(view, "opening"),
                       fmt::format("no particle has its centre within {} m of ({} m, {} m), under the 'foot' {}",
                                   0.5 * pair.foot, place.x, place.y, view.where()));
  return {};
}

}  // namespace ligament
