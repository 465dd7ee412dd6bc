#pragma once

#include <vector>

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// Makes the loading follow the gauge that the case names, if it names one; what is wrong with it becomes an error of
/// the case file.
void set_control(Case& input, const std::vector<Gauge>& gauges, IncrementalLoading& loading);

}  // namespace ligament
