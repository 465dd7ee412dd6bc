#include "generation/hexagonal.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/packing_report.hpp"
#include "generation/particle_limit.hpp"

namespace ligament {
namespace {

/// The lattice along and across its lines.
struct Lattice {
  std::size_t n_per_line = 0;  ///< in the long lines
  std::size_t n_lines = 0;
  double pitch = 0.0;       ///< along a line (m)
  double line_pitch = 0.0;  ///< from line to line (m)
};

/// Distance between neighbours of adjacent lines (m).
double oblique_distance(double pitch, double line_pitch) {
  return std::sqrt(0.25 * pitch * pitch + line_pitch * line_pitch);
}

Lattice fit_lattice(double along, double across, double radius) {
  constexpr double rounding = 1e-9;           // A region of exactly k diameters holds k discs.
  const double free_length = along - radius;  // The long lines end half a radius from the border.
  const double free_height = across - 2.0 * radius;
  const double n_pitches = std::ceil(free_length / (2.0 * radius) * (1.0 - rounding));
  Lattice lattice;
  lattice.pitch = free_length / n_pitches;
  double n_line_pitches = std::max(1.0, std::round(free_height / (std::sqrt(0.75) * lattice.pitch)));
  while (oblique_distance(lattice.pitch, free_height / n_line_pitches) > 2.0 * radius) n_line_pitches += 1.0;
  check_particle_count((n_pitches + 1.0) * (n_line_pitches + 1.0));
  lattice.line_pitch = free_height / n_line_pitches;
  lattice.n_per_line = static_cast<std::size_t>(n_pitches) + 1;
  lattice.n_lines = static_cast<std::size_t>(n_line_pitches) + 1;
  return lattice;
}

}  // namespace

void Hexagonal::declare(Parameters& parameters) {
  parameters.quantity("radius", radius_, "m", "radius R of the particles").required().greater_than(0.0);
  parameters.choice("lines", lines_, {{"shorter_side", Lines::shorter_side}, {"x", Lines::x}, {"y", Lines::y}},
                    "what the lines of the lattice run along");
}

Packing Hexagonal::generate(const Rectangle& region, std::uint64_t /*seed*/) const {
  const Vector size = region.size();
  const bool along_x = lines_ == Lines::x || (lines_ == Lines::shorter_side && size.x <= size.y);
  const double along = along_x ? size.x : size.y;
  const double across = along_x ? size.y : size.x;
  if (along < 3.0 * radius_ || across < 4.0 * radius_) {
    throw InputError(
        fmt::format("a hexagonal assembly of radius {} m does not fit into {} m × {} m", radius_, size.x, size.y));
  }
  const Lattice lattice = fit_lattice(along, across, radius_);
  Packing packing;
  for (std::size_t line = 0; line < lattice.n_lines; ++line) {
    const bool is_short = line % 2 == 1;
    const double start = 0.5 * radius_ + (is_short ? 0.5 * lattice.pitch : 0.0);
    const double height = radius_ + static_cast<double>(line) * lattice.line_pitch;
    for (std::size_t i = 0; i < lattice.n_per_line - (is_short ? 1 : 0); ++i) {
      const double position = start + static_cast<double>(i) * lattice.pitch;
      packing.position.push_back(region.from + (along_x ? Vector{position, height} : Vector{height, position}));
      packing.radius.push_back(radius_);
    }
  }
  packing.report = packing_report(packing, region);
  packing.report.push_back({"pitch_m", lattice.pitch});
  packing.report.push_back({"line_pitch_m", lattice.line_pitch});
  return packing;
}

}  // namespace ligament
