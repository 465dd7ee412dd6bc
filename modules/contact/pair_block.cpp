#include "contact/pair_block.hpp"

namespace ligament {
namespace {

// Without branches, so that compilers make vector instructions of it; those are chosen when the program starts. Every
// operation rounds as it does alone, whatever the width.
[[gnu::target_clones("avx512f", "avx2", "default")]] int measure_small_turns(const PairBlock& __restrict pairs,
                                                                             BlockMotion& __restrict motion) {
  int n_large = 0;
  for (std::size_t i = 0; i < pairs.size; ++i) {
    const PointPairMotion pair = pairs.pair(i);
    const LineTurn turn = line_turn(pair);
    n_large += is_small_turn(turn.sine, turn.cosine) ? 0 : 1;
    motion.set(
        i, particle_pair_motion(pair, pairs.reference(i), pairs.discs(i), small_turn_angle(turn.sine, turn.cosine)));
  }
  return n_large;
}

}  // namespace

void measure_pairs(const PairBlock& pairs, BlockMotion& motion) {
  if (measure_small_turns(pairs, motion) == 0) return;
  for (std::size_t i = 0; i < pairs.size; ++i) {
    motion.set(i, particle_pair_motion(pairs.pair(i), pairs.reference(i), pairs.discs(i)));
  }
}

}  // namespace ligament
