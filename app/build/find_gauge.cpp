#include "build/find_gauge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/closest_name.hpp"

namespace ligament {

const Gauge* find_gauge(Case& input, const std::vector<Gauge>& gauges, const std::string& wanted, const TableView& view,
                        const char* key) {
  const auto found =
      std::find_if(gauges.begin(), gauges.end(), [&](const Gauge& gauge) { return gauge.name == wanted; });
  if (found != gauges.end()) return &*found;
  std::vector<std::string> names;
  for (const Gauge& gauge : gauges) names.push_back(gauge.name);
  input.file.add_error(input.file.position(view, key),
                       fmt::format("there is no gauge '{}' {} (there are: {}){}", wanted, view.where(),
                                   names.empty() ? "none" : quoted_list(names), did_you_mean(wanted, names)));
  return nullptr;
}

}  // namespace ligament
