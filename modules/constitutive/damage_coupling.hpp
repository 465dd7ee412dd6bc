#pragma once

#include <algorithm>

#include "core/constitutive_law.hpp"

namespace ligament {

/// How the damages of tension and shear, D_t and D_s, act on each other's strength.
enum class DamageCoupling {
  sum,      ///< both strengths are (1 - D_t - D_s) of what they were
  largest,  ///< (1 - max(D_t, D_s))
  none,     ///< each has its own
};

/// The part of its strength that a mode with damage `own` has left beside the damage of the other.
inline double strength_left(DamageCoupling coupling, double own, double other) {
  switch (coupling) {
    case DamageCoupling::sum:
      return std::max(0.0, 1.0 - own - other);
    case DamageCoupling::largest:
      return 1.0 - std::max(own, other);
    case DamageCoupling::none:
      break;
  }
  return 1.0 - own;
}

/// The part of its strength that a mode has lost through the damage of the other.
inline double strength_lost_to(DamageCoupling coupling, double own, double other) {
  return (1.0 - own) - strength_left(coupling, own, other);
}

/// What a bond has lost in the mode with the larger damage, to which it is put down.
inline ContactDamage combined_damage(DamageCoupling coupling, double tension, double shear) {
  const double larger = std::max(tension, shear);
  if (larger <= 0.0) return {};
  return {1.0 - strength_left(coupling, larger, std::min(tension, shear)),
          tension >= shear ? FractureMode::tension : FractureMode::shear};
}

/// Whether nothing holds any more, to rounding.
inline bool is_broken(DamageCoupling coupling, double tension, double shear) {
  constexpr double rounding = 1e-15;
  const double left = strength_left(coupling, tension, shear);
  return std::max(left, coupling == DamageCoupling::none ? 1.0 - shear : 0.0) <= rounding;
}

}  // namespace ligament
