#include "build/build_gauges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "build/select_bodies.hpp"
#include "contact/region_mean.hpp"
#include "integrator/platens.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {
namespace {

/// The node, particle or node of a beam that a gauge watches, and its weight in a mean.
struct WatchedBody {
  BodyTable body = BodyTable::node;
  Index row = -1;
  int axis = 0;
  double weight = 1.0;

  [[nodiscard]] double displacement(const State& state) const {
    return component(translation_of(state, body).displacement[row], axis);
  }
  [[nodiscard]] double holding(const Model& model, const State& state) const {
    const Vector force = body == BodyTable::node
                             ? holding_force(model, state, row)
                             : reaction(translation_of(state, body), free_of(model, body), state.clock, row);
    return component(force, axis);
  }
  [[nodiscard]] Index freedom(const Model& model) const {
    const FreedomNumbers numbers(model);
    if (body == BodyTable::node) return numbers.node(row, axis);
    return body == BodyTable::particle ? numbers.particle(row, axis) : numbers.beam_node(row, axis);
  }
};

int axis_of(const GaugePoint& point) { return point.direction == "y" ? 1 : 0; }

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

Gauge opening_gauge(const Model& model, const std::string& name, const WatchedBody& from, const WatchedBody& to) {
  return {name,
          name + "_m",
          [from, to](const Model&, const State& state) { return to.displacement(state) - from.displacement(state); },
          {{from.freedom(model), -1.0}, {to.freedom(model), 1.0}}};
}

std::vector<WatchedBody> node_of_beam(Case& input, const Model& model, const GaugePoint& point, const TableView& view,
                                      const char* key) {
  const Beam* beam = find_beam(model, *point.beam, input.file, view, key);
  if (beam == nullptr) return {};
  const std::int64_t number = point.node.value_or(0);
  if (number >= 1 && number <= beam->n_nodes) {
    return {{BodyTable::beam_node, beam->first_node + static_cast<Index>(number - 1), axis_of(point)}};
  }
  input.file.add_error(input.file.position(view, key),
                       fmt::format("'{}' needs the number of a 'node' of beam '{}', from 1 to {} {}", key, beam->name,
                                   beam->n_nodes, view.where()));
  return {};
}

/// What a gauge watches: a body, or both ends of a wall; none if the case is wrong.
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
  if (!point.supports.empty()) return bodies_of_supports(input, model, point.supports, axis_of(point), view, key);
  if (point.point) return bodies_at(input, model, to_vector(*point.point), axis_of(point), view, key);
  if (point.wall) {
    const auto wall = find_wall(model, *point.wall, input.file, view, key);
    if (!wall) return {};
    const auto nodes = model.wall_nodes(*wall);
    return {{BodyTable::node, nodes[0], axis_of(point)}, {BodyTable::node, nodes[1], axis_of(point)}};
  }
  if (point.beam) return node_of_beam(input, model, point, view, key);
  const bool is_node = point.node.has_value();
  const std::int64_t number = is_node ? *point.node : *point.particle;
  const Index row = row_of_id(is_node ? model.nodes.id : model.particles.id, number);
  if (row >= 0) return {{is_node ? BodyTable::node : BodyTable::particle, row, axis_of(point)}};
  input.file.add_error(position,
                       fmt::format("there is no {} {} {}: it is beyond the last one or a zone has replaced it",
                                   is_node ? "node" : "particle", number, view.where()));
  return {};
}

double mean_displacement(const std::vector<WatchedBody>& bodies, const State& state) {
  double sum = 0.0;
  double weight = 0.0;
  for (const WatchedBody& body : bodies) {
    sum += body.weight * body.displacement(state);
    weight += body.weight;
  }
  return sum / weight;
}

/// The same as a weighted sum of freedoms, times a factor.
void add_mean(const Model& model, const std::vector<WatchedBody>& bodies, double factor,
              std::vector<SpringTerm>& displacements) {
  double weight = 0.0;
  for (const WatchedBody& body : bodies) weight += body.weight;
  for (const WatchedBody& body : bodies) displacements.push_back({body.freedom(model), factor * body.weight / weight});
}

/// Of a wall, the mean of its ends.
Gauge displacement_gauge(Case& input, const Model& model, const GaugeTable& table, const TableView& view) {
  const GaugePoint& point = table.displacement;
  const std::vector<WatchedBody> bodies = find_bodies(input, model, point, view, "displacement");
  const std::vector<WatchedBody> others =
      bodies_of_supports(input, model, point.relative_to, axis_of(point), view, "displacement");
  std::vector<SpringTerm> displacements;
  add_mean(model, bodies, 1.0, displacements);
  add_mean(model, others, -1.0, displacements);
  return {table.name, table.name + "_m",
          [bodies, others](const Model&, const State& state) {
            const double displacement = mean_displacement(bodies, state);
            return others.empty() ? displacement : displacement - mean_displacement(others, state);
          },
          std::move(displacements)};
}

Gauge reaction_gauge(const std::string& name, const std::vector<WatchedBody>& bodies) {
  return {name, name + "_N", [bodies](const Model& model, const State& state) {
            double sum = 0.0;
            for (const WatchedBody& body : bodies) {
              sum += body.holding(model, state);
            }
            return sum;
          }};
}

void check_is_held(Case& input, const Model& model, const std::vector<WatchedBody>& bodies,
                   const std::string& direction, const TableView& view) {
  const bool is_held = std::all_of(bodies.begin(), bodies.end(), [&](const WatchedBody& body) {
    return component(free_of(model, body.body)[body.row], body.axis) == 0.0;
  });
  if (is_held) return;
  input.file.add_error(input.file.position(view, "reaction"),
                       fmt::format("nothing holds or moves this body along {} {}: it has no reaction; take one "
                                   "of a [[support]] or [[motion]]",
                                   direction, view.where()));
}

double component(const SymmetricTensor& tensor, const std::string& name) {
  return name == "xx" ? tensor.xx : name == "yy" ? tensor.yy : tensor.xy;
}

Rectangle find_region(Case& input, const Model& model, const GaugeRegion& table, const TableView& view,
                      const char* key) {
  const Rectangle region{to_vector(table.from), to_vector(table.to)};
  if (!(region.from.x < region.to.x && region.from.y < region.to.y)) {
    input.file.add_error(input.file.position(view, key),
                         fmt::format("'to' must lie above and right of 'from' {}", view.where()));
  } else if (count_particles(model, region) < 3) {
    input.file.add_error(input.file.position(view, key),
                         fmt::format("fewer than three particles are in the region {}", view.where()));
  }
  return region;
}

Gauge stress_gauge(const std::string& name, const Rectangle& region, const std::string& of) {
  return {name, name + "_Pa", [region, of](const Model& model, const State& state) {
            return component(mean_stress(model, state, region), of);
          }};
}

Gauge strain_gauge(const std::string& name, const Rectangle& region, const std::string& of) {
  return {name, name + "_1", [region, of](const Model& model, const State& state) {
            return component(mean_strain(model, state, region), of);
          }};
}

Gauge build_gauge(Case& input, const Model& model, const GaugeTable& table, const TableView& view) {
  if (table.displacement.is_given) {
    return displacement_gauge(input, model, table, view);
  }
  if (table.reaction.is_given) {
    const auto bodies = find_bodies(input, model, table.reaction, view, "reaction");
    check_is_held(input, model, bodies, table.reaction.direction, view);
    return reaction_gauge(table.name, bodies);
  }
  if (table.stress.is_given) {
    return stress_gauge(table.name, find_region(input, model, table.stress, view, "stress"), table.stress.component);
  }
  if (table.opening.is_given) {
    const int axis = table.opening.direction == "y" ? 1 : 0;
    return opening_gauge(model, table.name, nearest_body(model, to_vector(table.opening.from), axis),
                         nearest_body(model, to_vector(table.opening.to), axis));
  }
  return strain_gauge(table.name, find_region(input, model, table.strain, view, "strain"), table.strain.component);
}

Gauge scaled(Gauge gauge, double factor) {
  if (factor == 1.0) return gauge;
  for (SpringTerm& term : gauge.displacements) term.factor *= factor;
  gauge.value = [factor, value = std::move(gauge.value)](const Model& model, const State& state) {
    return factor * value(model, state);
  };
  return gauge;
}

}  // namespace

std::vector<Gauge> build_gauges(Case& input, const Model& model) {
  std::vector<Gauge> gauges;
  for (const auto& [table, view] : input.gauges) {
    const int n_given = table.displacement.is_given + table.reaction.is_given + table.opening.is_given +
                        table.stress.is_given + table.strain.is_given;
    if (n_given == 1) {
      gauges.push_back(scaled(build_gauge(input, model, table, view), table.factor));
    } else {
      input.file.add_error(
          input.file.position(view),
          fmt::format("a gauge measures one thing: give 'displacement', 'reaction', 'opening', 'stress' or 'strain' {}",
                      view.where()));
    }
  }
  return gauges;
}

}  // namespace ligament
