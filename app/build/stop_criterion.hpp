#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// Ends a run by what a gauge shows.
struct StopCriterion {
  std::size_t gauge = 0;  ///< its number
  std::string name;       ///< its name
  GaugeLimit limit;

  /// From the readings of all gauges now, and their largest ones so far: what has been reached, in words; empty if
  /// nothing has.
  [[nodiscard]] std::string reached(const std::vector<double>& readings, const Field<double>& peaks) const;
};

/// Those of the case, the one of [stop] first; what is wrong with them becomes an error of the case file.
std::vector<StopCriterion> build_stop_criteria(Case& input, const std::vector<Gauge>& gauges);

}  // namespace ligament
