#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// The gauge that a key of a table names; null, and an error of the case file, if there is none.
const Gauge* find_gauge(Case& input, const std::vector<Gauge>& gauges, const std::string& wanted, const TableView& view,
                        const char* key);

}  // namespace ligament
