#pragma once

#include <optional>
#include <span>
#include <string>

#include "run/crack_planes.hpp"

namespace ligament {

/// The connected crack that spans most.
struct MacroCrack {
  Field<Vector> path;       ///< from one end to the other, through the points where neighbouring planes meet (m)
  double span = 0.0;        ///< distance of the ends (m)
  double length = 0.0;      ///< along the path (m)
  double tortuosity = 1.0;  ///< length over the distance of its ends
  double damaged_width =
      0.0;  ///< of the band along the path that holds 90 % of the energy spent, 5 % on either side (m)
};

/// Planes that are broken, or have lost more than nine tenths of their strength, are connected if no further apart than
/// half the shorter one. Of the connected sets the one with the largest distance between two of its points is taken;
/// the path is the shortest chain of planes between these two. Nothing if no plane has lost so much.
std::optional<MacroCrack> find_macro_crack(std::span<const CrackPlane> planes);

/// Its path as CSV: `x_m`, `y_m`.
std::string path_table(const MacroCrack& crack);

}  // namespace ligament
