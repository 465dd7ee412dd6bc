#pragma once

#include "core/generator.hpp"
#include "generation/random_numbers.hpp"

namespace ligament {

/// Discs of these radii (m, in descending order) squeezed into the box [0, size]: thrown in at 40 % of their size,
/// grown in steps, and let push each other until they are at rest. Throws InputError if a disc finds no room.
Packing grow_discs(const Field<double>& radii, const Vector& size, RandomNumbers& random);

/// Lets the discs of a packing in the box [0, size] push each other until they are at rest.
void settle(Packing& packing, const Vector& size);

}  // namespace ligament
