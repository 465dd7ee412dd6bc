#pragma once

#include "core/generator.hpp"

namespace ligament {

/// Puts discs of this radius (m) into every void of a packing in the box [0, size] whose largest empty circle has a
/// radius above `smallest_void` (m), lets all discs come to rest, and goes on until there is no such void. Returns the
/// number of discs put in. Throws InputError if voids keep opening.
std::size_t eliminate_voids(Packing& packing, const Vector& size, double radius, double smallest_void);

}  // namespace ligament
