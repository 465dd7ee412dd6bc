#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

struct ReportOptions {
  double scale = 1.0;                               ///< factor on displacements in the picture of cracks
  std::optional<std::int64_t> step;                 ///< of the fields; the last output if not given
  std::vector<std::array<Vector, 2>> notches = {};  ///< ends of their middle lines (m)
};

/// Draws the curves and the cracks of a run into `<run>/report/`, each as SVG and PNG, and puts them with the numbers
/// of the summary on one self-contained page. Returns the path of the page. FileError if something is missing.
std::filesystem::path write_report(const std::filesystem::path& run, const ReportOptions& options);

}  // namespace ligament
