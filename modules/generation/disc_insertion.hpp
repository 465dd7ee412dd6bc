#pragma once

#include <span>

#include "core/vector.hpp"
#include "generation/random_numbers.hpp"

namespace ligament {

/// Centres of discs thrown at random into the box [0, size], where none overlaps another or a wall (random sequential
/// addition). The radii must come in descending order: what is large finds no room later. Throws InputError if a disc
/// finds no room.
Field<Vector> insert_discs(std::span<const double> radii, const Vector& size, RandomNumbers& random);

}  // namespace ligament
