#include "build/uniaxial_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "build/find_gauge.hpp"

namespace ligament {
namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double length() const { return high - low; }
};

/// What zones and elements reach over along an axis.
Interval extent(const Case& input, std::size_t axis) {
  Interval reach;
  for (const auto& [zone, view] : input.zones) {
    reach.add(zone.from[axis]);
    reach.add(zone.to[axis]);
  }
  if (!input.mesh) return reach;
  const MeshTable& mesh = input.mesh->table;
  for (const double line : axis == 0 ? mesh.x : mesh.y) reach.add(line);
  return reach;
}

}  // namespace

std::optional<UniaxialTest> build_uniaxial_test(Case& input, const std::vector<Gauge>& gauges) {
  if (!input.uniaxial) return std::nullopt;
  const auto& [table, view] = *input.uniaxial;
  const Gauge* load = find_gauge(input, gauges, table.load, view, "load");
  const Gauge* elongation = find_gauge(input, gauges, table.elongation, view, "elongation");
  if (load == nullptr || elongation == nullptr) return std::nullopt;
  const auto of_load = std::find_if(input.gauges.begin(), input.gauges.end(),
                                    [&name = table.load](const auto& gauge) { return gauge.table.name == name; });
  if (!of_load->table.reaction.is_given) {
    input.file.add_error(input.file.position(view, "load"),
                         fmt::format("gauge '{}' is no 'reaction' {}: it tells of no load", table.load, view.where()));
    return std::nullopt;
  }
  const std::size_t axis = of_load->table.reaction.direction == "y" ? 1 : 0;
  return UniaxialTest{.load = static_cast<std::size_t>(load - gauges.data()),
                      .elongation = static_cast<std::size_t>(elongation - gauges.data()),
                      .axis = static_cast<int>(axis),
                      .length = extent(input, axis).length(),
                      .area = extent(input, 1 - axis).length() * input.problem.thickness};
}

}  // namespace ligament
