#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// Ends a run by what a gauge shows.
struct StopCriterion {
  std::size_t gauge = 0;  ///< its number
  std::optional<double> drop_to_share;
  std::optional<double> above;
  std::optional<double> below;

  /// From the readings of all gauges now, and their largest ones so far.
  [[nodiscard]] bool is_reached(const std::vector<double>& readings, const Field<double>& peaks) const;
};

/// That of the case, if it has one; what is wrong with it becomes an error of the case file.
std::optional<StopCriterion> build_stop_criterion(Case& input, const std::vector<Gauge>& gauges);

}  // namespace ligament
