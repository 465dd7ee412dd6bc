#include "build/stop_criterion.hpp"

#include <fmt/format.h>

#include "build/find_gauge.hpp"

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
  const Gauge* gauge = find_gauge(input, gauges, table.gauge.value_or(""), view, "gauge");
  if (gauge == nullptr) return std::nullopt;
  if (!table.drop_to_share && !table.above && !table.below) {
    input.file.add_error(input.file.position(view),
                         fmt::format("give 'drop_to_share', 'above' or 'below' {}", view.where()));
  }
  return StopCriterion{static_cast<std::size_t>(gauge - gauges.data()), table.drop_to_share, table.above, table.below};
}

}  // namespace ligament
