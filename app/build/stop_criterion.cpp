#include "build/stop_criterion.hpp"

#include <fmt/format.h>

#include "build/find_gauge.hpp"

namespace ligament {
namespace {

bool is_given(const GaugeLimit& limit) { return limit.drop_to_share || limit.above || limit.below; }

void add_criterion(Case& input, const std::vector<Gauge>& gauges, const std::string& gauge, const GaugeLimit& limit,
                   const TableView& view, std::vector<StopCriterion>& criteria) {
  if (!is_given(limit)) {
    input.file.add_error(input.file.position(view),
                         fmt::format("give 'drop_to_share', 'above' or 'below' {}", view.where()));
  }
  const Gauge* found = find_gauge(input, gauges, gauge, view, "gauge");
  if (found != nullptr) criteria.push_back({static_cast<std::size_t>(found - gauges.data()), gauge, limit});
}

}  // namespace

std::string StopCriterion::reached(const std::vector<double>& readings, const Field<double>& peaks) const {
  const double now = readings[gauge];
  // While nothing has risen, nothing has dropped.
  if (limit.drop_to_share && peaks[gauge] > 0.0 && now <= *limit.drop_to_share * peaks[gauge]) {
    return fmt::format("gauge '{}' has dropped to {} of its peak", name, *limit.drop_to_share);
  }
  if (limit.above && now > *limit.above) return fmt::format("gauge '{}' is above {}", name, *limit.above);
  if (limit.below && now < *limit.below) return fmt::format("gauge '{}' is below {}", name, *limit.below);
  return {};
}

std::vector<StopCriterion> build_stop_criteria(Case& input, const std::vector<Gauge>& gauges) {
  std::vector<StopCriterion> criteria;
  if (input.stop) {
    const auto& [table, view] = *input.stop;
    if (table.gauge) {
      add_criterion(input, gauges, *table.gauge, table.limit, view, criteria);
    } else if (is_given(table.limit)) {
      input.file.add_error(input.file.position(view), fmt::format("missing key 'gauge' {}", view.where()));
    } else if (!table.cut_off_share && !table.crack_span) {
      input.file.add_error(input.file.position(view),
                           fmt::format("give 'gauge', 'cut_off_share' or 'crack_span' {}", view.where()));
    }
  }
  for (const auto& [table, view] : input.limits) add_criterion(input, gauges, table.gauge, table.limit, view, criteria);
  return criteria;
}

}  // namespace ligament
