#pragma once

#include <cmath>
#include <string>

#include "core/vector.hpp"

namespace ligament {

/// A straight cut, made before anything else: a segment without width, or a slit around it.
struct Notch {
  std::string name;
  Vector from;              ///< one end of its middle line (m)
  Vector to;                ///< the other end (m)
  double width = 0.0;       ///< of the slit; 0 for a cut that takes nothing away (m)
  double gap = 0.0;         ///< by which its faces stand apart for what it separates (m)
  std::size_t n_taken = 0;  ///< particles and elements that the slit has taken away
};

/// Whether the branch between two points crosses the middle line, or touches an end of it.
inline bool separates(const Notch& notch, const Vector& a, const Vector& b) {
  const Vector along = notch.to - notch.from;
  const bool is_left = cross(along, a - notch.from) > 0.0;
  if (is_left == (cross(along, b - notch.from) > 0.0)) return false;
  const Vector branch = b - a;
  return cross(branch, notch.from - a) * cross(branch, notch.to - a) <= 0.0;
}

/// Whether a point lies in the slit, off its border.
inline bool is_in_slit(const Notch& notch, const Vector& point) {
  const Vector along = notch.to - notch.from;
  const Vector place = point - notch.from;
  const double position = dot(place, along);
  return position > 0.0 && position < dot(along, along) &&
         std::abs(cross(along, place)) < 0.5 * notch.width * norm(along);
}

}  // namespace ligament
