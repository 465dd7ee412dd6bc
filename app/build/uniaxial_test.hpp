#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "gauge.hpp"

namespace ligament {

/// A specimen under load along one axis, and the gauges that tell of it.
struct UniaxialTest {
  std::size_t load = 0;        ///< number of the gauge of the load
  std::size_t elongation = 0;  ///< of the gauge of the elongation
  int axis = 0;
  double length = 0.0;  ///< of all zones and elements together, along the axis (m)
  double area = 0.0;    ///< their cross-section (m2)
};

/// That of the case, if it is of the kind "uniaxial"; what is wrong with it becomes an error of the case file.
std::optional<UniaxialTest> build_uniaxial_test(Case& input, const std::vector<Gauge>& gauges);

}  // namespace ligament
