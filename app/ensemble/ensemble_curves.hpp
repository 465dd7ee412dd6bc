#pragma once

#include <filesystem>
#include <vector>

#include "ensemble/ensemble_tables.hpp"

namespace ligament {

/// Of every group of runs with the same swept values, writes curve.csv into its folder: mean, standard deviation, least
/// and largest load over the abscissa of the case, of the runs that are done. Draws them as ensemble.svg and
/// ensemble.png. Returns false if no case has a load over a displacement that all of its runs share; FileError if
/// gnuplot cannot draw, after the tables have been written.
bool write_ensemble_curves(const std::filesystem::path& folder, const std::vector<EnsembleRow>& rows);

}  // namespace ligament
