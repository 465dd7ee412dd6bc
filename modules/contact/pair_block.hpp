#pragma once

#include "contact/block_motion.hpp"

namespace ligament {

/// A block of pairs of discs, fetched from their bodies and from what their contacts remember, in columns.
struct PairBlock {
  std::size_t size = 0;
  VectorColumns<contact_block_size> rest;  ///< see PointPairMotion
  VectorColumns<contact_block_size> displacement;
  VectorColumns<contact_block_size> increment;
  BlockColumn<Rotation> turn_first;  ///< see DiscPair
  BlockColumn<Rotation> turn_second;
  BlockColumn<double> radius_difference;
  BlockColumn<double> rest_distance;  ///< see ContactReference
  BlockColumn<double> initial_gap;
  BlockColumn<double> previous_opening;

  void set(std::size_t i, const PointPairMotion& pair, const DiscPair& discs, const ContactReference& reference) {
    rest.set(i, pair.rest);
    displacement.set(i, pair.displacement);
    increment.set(i, pair.increment);
    turn_first[i] = discs.turn_first;
    turn_second[i] = discs.turn_second;
    radius_difference[i] = discs.radius_difference;
    rest_distance[i] = reference.rest_distance;
    initial_gap[i] = reference.initial_gap;
    previous_opening[i] = reference.previous_opening;
  }
  [[nodiscard]] PointPairMotion pair(std::size_t i) const { return {rest[i], displacement[i], increment[i]}; }
  [[nodiscard]] DiscPair discs(std::size_t i) const { return {turn_first[i], turn_second[i], radius_difference[i]}; }
  [[nodiscard]] ContactReference reference(std::size_t i) const {
    return {rest_distance[i], initial_gap[i], previous_opening[i]};
  }
};

/// particle_pair_motion() of all pairs of the block, to the same bits, as many at a time as the processor can take.
void measure_pairs(const PairBlock& pairs, BlockMotion& motion);

}  // namespace ligament
