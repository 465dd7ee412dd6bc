#include "build/build_gauges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "build/watched_bodies.hpp"
#include "contact/region_mean.hpp"

namespace ligament {
namespace {

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

/// How far one mean displacement is ahead of another; of itself, if there is no other.
Gauge difference_gauge(const Model& model, const std::string& name, std::vector<WatchedBody> bodies,
                       std::vector<WatchedBody> others) {
  std::vector<SpringTerm> displacements;
  add_mean(model, bodies, 1.0, displacements);
  add_mean(model, others, -1.0, displacements);
  return {name, name + "_m",
          [bodies = std::move(bodies), others = std::move(others)](const Model&, const State& state) {
            const double displacement = mean_displacement(bodies, state);
            return others.empty() ? displacement : displacement - mean_displacement(others, state);
          },
          std::move(displacements)};
}

Gauge opening_gauge(Case& input, const Model& model, const GaugeTable& table, const TableView& view) {
  const GaugePair& pair = table.opening;
  const Vector from = to_vector(pair.from);
  const Vector to = to_vector(pair.to);
  return difference_gauge(model, table.name, bodies_of_end(input, model, pair, to, from, view),
                          bodies_of_end(input, model, pair, from, to, view));
}

/// Of a wall, the mean of its ends.
Gauge displacement_gauge(Case& input, const Model& model, const GaugeTable& table, const TableView& view) {
  const GaugePoint& point = table.displacement;
  return difference_gauge(
      model, table.name, find_bodies(input, model, point, view, "displacement"),
      bodies_of_supports(input, model, point.relative_to, axis_of(point.direction), view, "displacement"));
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
  if (table.opening.is_given) return opening_gauge(input, model, table, view);
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
