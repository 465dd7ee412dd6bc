#pragma once

#include <string>
#include <vector>

#include "io/csv_table.hpp"

namespace ligament {

/// The columns of the gauges of a history: they stand between the time and the number of broken bonds.
std::vector<std::string> gauges_of(const CsvContent& history);

/// A column in N, and columns in m to draw it over; either may be missing.
struct LoadCurves {
  std::string load;  ///< `load_N`, or else the first force
  /// `deflection_m`, `cmod_m` and `cmsd_m`, those that are there; or else the first displacement.
  std::vector<std::string> displacements;
  bool are_named = true;  ///< whether some of these names are there, and a force
};

LoadCurves load_curves(const CsvContent& history);

}  // namespace ligament
