#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "report/gnuplot.hpp"
#include "report/report.hpp"

namespace ligament {

/// The step of the last output of fields in a run directory; FileError if there is none.
std::int64_t last_field_step(const std::filesystem::path& run);

/// Particles as discs, the outlines of elements and walls, notches where they were cut, and the planes of bonds that
/// soften or have broken as lines, coloured by mode, at this output; where there are elements, a second picture of the
/// particles alone. Writes the data of the figures into `folder`. FileError if the fields of the step or cracks.csv
/// cannot be read.
std::vector<Figure> crack_pictures(const std::filesystem::path& run, std::int64_t step, const ReportOptions& options,
                                   const std::filesystem::path& folder);

}  // namespace ligament
