#pragma once

#include "core/generator.hpp"

namespace ligament {

/// Which voids are filled, and with what.
struct VoidFilling {
  double disc_radius = 0.0;    ///< of the discs put in (m)
  double smallest_void = 0.0;  ///< radius of the largest empty circle of voids that are left (m)

  /// Width (m) of the border strip without voids: empty circles keep clear of it. So a disc in the centre of a void
  /// does not overlap the border, and the gaps between the outermost particles and the border are no voids.
  [[nodiscard]] double border() const { return disc_radius > smallest_void ? disc_radius - smallest_void : 0.0; }
};

/// Puts discs into every void of a packing in the box [0, size] that is larger than what is left, lets all discs come
/// to rest, and goes on until there is no such void. Returns the number of discs put in. Throws InputError if voids
/// keep opening.
std::size_t eliminate_voids(Packing& packing, const Vector& size, const VoidFilling& filling);

/// Radius (m) of the largest void of a packing off the border, or 0 if it is below half of those that are left.
double largest_void_left(const Packing& packing, const Vector& size, const VoidFilling& filling);

}  // namespace ligament
