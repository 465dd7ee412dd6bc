#pragma once

#include <optional>

#include "run/crack_planes.hpp"

namespace ligament {

/// Where two planes come closest to each other.
struct Meeting {
  double gap = 0.0;  ///< between them, 0 if they cross (m)
  Vector point;      ///< where they cross, or half-way between them (m)
};
Meeting meeting(const CrackPlane& a, const CrackPlane& b);

/// Distance of a point from a path of straight pieces (m), positive to its left; nothing if it lies beyond one of its
/// ends.
std::optional<double> distance_beside(const Field<Vector>& path, const Vector& point);

}  // namespace ligament
