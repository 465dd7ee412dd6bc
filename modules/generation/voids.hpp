#pragma once

#include <vector>

#include "generation/tangent_circles.hpp"

namespace ligament {

/// Empty circles of a radius above `smallest` (m, > 0) between discs in the box [0, size], each in touch with three
/// discs or walls, the largest first. Every hole where such a circle finds room has one at least, if not its largest.
///
/// Where a circle of radius r finds room, the discs grown by r leave a hole in the box shrunk by r. A hole has corners,
/// where the outlines of two grown discs or walls meet; from there a circle in touch with both grows until it meets a
/// third.
std::vector<Circle> find_voids(const Field<Vector>& centres, const Field<double>& radii, const Vector& size,
                               double smallest);

/// Radius (m) of the largest empty circle of all, or 0 if none is larger than `smallest` (m, > 0).
double largest_void(const Field<Vector>& centres, const Field<double>& radii, const Vector& size, double smallest);

}  // namespace ligament
