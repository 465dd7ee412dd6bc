#include <doctest/doctest.h>

#include "contact/pair_block.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Pairs that turn in the step by up to this angle (rad), and one by much more if it is asked for.
PairBlock random_pairs(std::size_t size, double turn, bool has_large_turn, RandomNumbers& random) {
  PairBlock pairs;
  pairs.size = size;
  for (std::size_t i = 0; i < size; ++i) {
    const Vector rest = random.uniform(0.5, 2.0) * random.direction();
    const double scale = has_large_turn && i == size / 2 ? 3.0 : turn;
    const ContactReference reference{norm(rest), random.uniform(-0.1, 0.1), random.uniform(-0.01, 0.01)};
    pairs.set(i, {rest, random.vector(1e-3), random.vector(scale)},
              {random.uniform(-turn, turn), random.uniform(-turn, turn), random.uniform(-0.3, 0.3)}, reference);
  }
  return pairs;
}

}  // namespace

TEST_CASE("pairs measured block by block have the bits of pairs measured one by one") {
  RandomNumbers random(11);
  for (const std::size_t size : {1, 7, 64, 101, 128}) {
    for (const bool has_large_turn : {false, true}) {
      CAPTURE(size);
      CAPTURE(has_large_turn);
      const PairBlock pairs = random_pairs(size, 1e-3, has_large_turn, random);
      BlockMotion motion;
      measure_pairs(pairs, motion);
      for (std::size_t i = 0; i < size; ++i) {
        const ContactMotion one = particle_pair_motion(pairs.pair(i), pairs.reference(i), pairs.discs(i));
        REQUIRE(motion.normal[i] == one.geometry.normal);
        REQUIRE(motion.arm_first[i] == one.geometry.arm_first);
        REQUIRE(motion.arm_second[i] == one.geometry.arm_second);
        REQUIRE(motion.opening[i] == one.opening);
        REQUIRE(motion.slip_increment[i] == one.slip_increment);
      }
    }
  }
}
