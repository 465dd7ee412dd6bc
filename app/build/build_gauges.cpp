#include "build/build_gauges.hpp"

#include <fmt/format.h>

#include "build/select_bodies.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {
namespace {

/// The body that a gauge watches.
struct WatchedBody {
  bool is_node = true;
  Index row = -1;
  int axis = 0;

  [[nodiscard]] const TranslationState& table(const State& state) const {
    return is_node ? state.nodes.translation : state.particles.translation;
  }
  [[nodiscard]] const Field<Vector>& free(const Model& model) const {
    return is_node ? model.nodes.free : model.particles.free;
  }
};

WatchedBody find_body(Case& input, const Model& model, const GaugePoint& point, const TableView& view,
                      const char* key) {
  const SourcePosition position = input.file.position(view, key);
  WatchedBody body{.is_node = point.node.has_value(), .axis = point.direction == "y" ? 1 : 0};
  if (point.node.has_value() == point.particle.has_value()) {
    input.file.add_error(position, fmt::format("'{}' needs either 'node' or 'particle' {}", key, view.where()));
    return body;
  }
  const std::int64_t number = body.is_node ? *point.node : *point.particle;
  body.row = row_of_id(body.is_node ? model.nodes.id : model.particles.id, number);
  if (body.row < 0) {
    input.file.add_error(position,
                         fmt::format("there is no {} {} {}: it is beyond the last one or a zone has replaced it",
                                     body.is_node ? "node" : "particle", number, view.where()));
  }
  return body;
}

Gauge displacement_gauge(const std::string& name, const WatchedBody& body) {
  return {name + "_m", [body](const Model&, const State& state) {
            return component(body.table(state).displacement[body.row], body.axis);
          }};
}

Gauge reaction_gauge(const std::string& name, const WatchedBody& body) {
  return {name + "_N", [body](const Model& model, const State& state) {
            return component(reaction(body.table(state), body.free(model), state.clock, body.row), body.axis);
          }};
}

}  // namespace

std::vector<Gauge> build_gauges(Case& input, const Model& model) {
  std::vector<Gauge> gauges;
  for (const auto& [table, view] : input.gauges) {
    if (table.displacement.is_given == table.reaction.is_given) {
      input.file.add_error(
          input.file.position(view),
          fmt::format("a gauge measures one thing: give 'displacement' or 'reaction' {}", view.where()));
    } else if (table.displacement.is_given) {
      const WatchedBody body = find_body(input, model, table.displacement, view, "displacement");
      gauges.push_back(displacement_gauge(table.name, body));
    } else {
      const WatchedBody body = find_body(input, model, table.reaction, view, "reaction");
      if (body.row >= 0 && component(body.free(model)[body.row], body.axis) != 0.0) {
        input.file.add_error(input.file.position(view, "reaction"),
                             fmt::format("nothing holds or moves this body along {} {}: it has no reaction; take one "
                                         "of a [[support]] or [[motion]]",
                                         table.reaction.direction, view.where()));
      }
      gauges.push_back(reaction_gauge(table.name, body));
    }
  }
  return gauges;
}

}  // namespace ligament
