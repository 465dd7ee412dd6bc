#include "contact/pair_block.hpp"

#include <cstdint>

// The loops are without branches, so that compilers make vector instructions of them; those are chosen when the program
// starts. Every operation rounds as it does alone, whatever the width.
namespace ligament {
namespace {

[[gnu::target_clones("avx512f", "avx2", "default")]] std::int64_t measure_small_turns(const PairBlock& __restrict pairs,
                                                                                      const BlockReferences& references,
                                                                                      BlockMotion& __restrict motion) {
  std::int64_t n_large = 0;  // as wide as the numbers beside it
  for (std::size_t i = 0; i < pairs.size; ++i) {
    const PointPairMotion pair = pairs.pair(i);
    const LineTurn turn = line_turn(pair);
    n_large += is_small_turn(turn.sine, turn.cosine) ? 0 : 1;
    motion.set(i, particle_pair_motion(pair, references[i], pairs.discs(i), small_turn_angle(turn.sine, turn.cosine)));
  }
  return n_large;
}

}  // namespace

void measure_pairs(const PairBlock& pairs, const BlockReferences& references, BlockMotion& motion) {
  if (measure_small_turns(pairs, references, motion) == 0) return;
  for (std::size_t i = 0; i < pairs.size; ++i) {
    motion.set(i, particle_pair_motion(pairs.pair(i), references[i], pairs.discs(i)));
  }
}

[[gnu::target_clones("avx512f", "avx2", "default")]] void find_pair_forces(std::size_t size,
                                                                           const BlockMotion& __restrict motion,
                                                                           const double* normal_force,
                                                                           const ShearVector* shear_force,
                                                                           BlockEndForces<2>& __restrict forces) {
  for (std::size_t i = 0; i < size; ++i) {
    const ContactGeometry geometry = motion.geometry(i);
    const ContactPointForce force = contact_point_force(geometry.normal, normal_force[i], shear_force[i]);
    forces.set(i, {force_on_first(geometry, force), force_on_second(geometry, force)});
  }
}

}  // namespace ligament
