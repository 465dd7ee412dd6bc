#include "build/stop_criterion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/closest_name.hpp"

namespace ligament {

bool StopCriterion::is_reached(const std::vector<double>& readings, const Field<double>& peaks) const {
  const double now = readings[gauge];
  // While nothing has risen, nothing has dropped.
  const bool has_dropped = drop_to_share && peaks[gauge] > 0.0 && now <= *drop_to_share * peaks[gauge];
  return has_dropped || (above && now > *above) || (below && now < *below);
}

std::optional<StopCriterion> build_stop_criterion(Case& input, const std::vector<Gauge>& gauges) {
  if (!input.stop) return std::nullopt;
  const auto& [table, view] = *input.stop;
  const std::string wanted = table.gauge.value_or("");
  const auto found =
      std::find_if(gauges.begin(), gauges.end(), [&](const Gauge& gauge) { return gauge.name == wanted; });
  if (found == gauges.end()) {
    std::vector<std::string> names;
    for (const Gauge& gauge : gauges) names.push_back(gauge.name);
    input.file.add_error(input.file.position(view, "gauge"),
                         fmt::format("there is no gauge '{}' {} (there are: {}){}", wanted, view.where(),
                                     names.empty() ? "none" : quoted_list(names), did_you_mean(wanted, names)));
    return std::nullopt;
  }
  if (!table.drop_to_share && !table.above && !table.below) {
    input.file.add_error(input.file.position(view),
                         fmt::format("give 'drop_to_share', 'above' or 'below' {}", view.where()));
  }
  return StopCriterion{static_cast<std::size_t>(found - gauges.begin()), table.drop_to_share, table.above, table.below};
}

}  // namespace ligament
