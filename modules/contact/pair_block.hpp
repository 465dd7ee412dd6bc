#pragma once

#include "contact/end_forces.hpp"

namespace ligament {

/// A block of pairs of discs, fetched from their bodies, in columns.
struct PairBlock {
  std::size_t size = 0;
  BlockVectors rest;  ///< see PointPairMotion
  BlockVectors displacement;
  BlockVectors increment;
  BlockColumn<Rotation> turn_first;  ///< see DiscPair
  BlockColumn<Rotation> turn_second;
  BlockColumn<double> radius_difference;

  void set(std::size_t i, const PointPairMotion& pair, const DiscPair& discs) {
    rest.set(i, pair.rest);
    displacement.set(i, pair.displacement);
    increment.set(i, pair.increment);
    turn_first[i] = discs.turn_first;
    turn_second[i] = discs.turn_second;
    radius_difference[i] = discs.radius_difference;
  }
  [[nodiscard]] PointPairMotion pair(std::size_t i) const { return {rest[i], displacement[i], increment[i]}; }
  [[nodiscard]] DiscPair discs(std::size_t i) const { return {turn_first[i], turn_second[i], radius_difference[i]}; }
};

/// What the contacts of a block remember of their distances: rows of their table.
struct BlockReferences {
  const double* rest_distance;  ///< see ContactReference
  const double* initial_gap;
  const double* previous_opening;

  [[nodiscard]] ContactReference operator[](std::size_t i) const {
    return {rest_distance[i], initial_gap[i], previous_opening[i]};
  }
};

/// particle_pair_motion() of all pairs of the block, to the same bits, as many at a time as the processor can take.
void measure_pairs(const PairBlock& pairs, const BlockReferences& references, BlockMotion& motion);

/// force_on_first() and force_on_second() of all pairs of a block that carry these forces (N), likewise.
void find_pair_forces(std::size_t size, const BlockMotion& motion, const double* normal_force,
                      const ShearVector* shear_force, BlockEndForces<2>& forces);

}  // namespace ligament
