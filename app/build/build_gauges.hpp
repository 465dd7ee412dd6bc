#pragma once

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// The gauges of a case; what they cannot measure becomes errors of the case file.
std::vector<Gauge> build_gauges(Case& input, const Model& model);

}  // namespace ligament
