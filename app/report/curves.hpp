#pragma once

#include <vector>

#include "io/csv_table.hpp"
#include "report/gnuplot.hpp"

namespace ligament {

/// Curves of the gauges: `load_N`, or else the first force, over `deflection_m`, `cmod_m` and `cmsd_m`; where none of
/// these is there, over the first displacement, and every gauge over time. `path` is where gnuplot finds the table.
std::vector<Figure> gauge_figures(const CsvContent& history, const std::string& path);

/// The terms of the energy ledger over time.
Figure energy_figure(const CsvContent& energy, const std::string& path);

}  // namespace ligament
