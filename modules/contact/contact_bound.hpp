#pragma once

#include <algorithm>
#include <cmath>

namespace ligament {

/// Rows that one contact adds to the Gershgorin bound of its bodies (N/m); see StiffnessBounds.
struct ContactBound {
  double translation = 0.0;
  double rotation_first = 0.0;
  double rotation_second = 0.0;
};

/// Eq. (29) row by row with rotations scaled by the radius; a lever is the arm of a body over its radius. The paper's
/// (30) leaves out the coupling of shear and rotation and is not a bound.
inline ContactBound contact_bound(double normal_stiffness, double shear_stiffness, double lever_first,
                                  double lever_second) {
  // The contact point of a disc that lies deep inside of another is on the far side of its centre.
  const double first = std::abs(lever_first);
  const double second = std::abs(lever_second);
  const double shear_row = shear_stiffness * (2.0 + first + second);
  return {.translation = std::max(2.0 * normal_stiffness, shear_row),
          .rotation_first = first * shear_row,
          .rotation_second = second * shear_row};
}

}  // namespace ligament
