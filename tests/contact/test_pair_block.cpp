#include <doctest/doctest.h>

#include "contact/pair_block.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// What contacts remember, in columns.
struct References {
  BlockColumn<double> rest_distance;
  BlockColumn<double> initial_gap;
  BlockColumn<double> opening;

  [[nodiscard]] BlockReferences columns() const { return {rest_distance.data(), initial_gap.data(), opening.data()}; }
};

/// Pairs that turn in the step by up to this angle (rad), and one by much more if it is asked for.
PairBlock random_pairs(std::size_t size, double turn, bool has_large_turn, References& references,
                       RandomNumbers& random) {
  PairBlock pairs;
  pairs.size = size;
  for (std::size_t i = 0; i < size; ++i) {
    const Vector rest = random.uniform(0.5, 2.0) * random.direction();
    const double scale = has_large_turn && i == size / 2 ? 3.0 : turn;
    references.rest_distance[i] = norm(rest);
    references.initial_gap[i] = random.uniform(-0.1, 0.1);
    references.opening[i] = random.uniform(-0.01, 0.01);
    pairs.set(i, {rest, random.vector(1e-3), random.vector(scale)},
              {random.uniform(-turn, turn), random.uniform(-turn, turn), random.uniform(-0.3, 0.3)});
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
      References references;
      const PairBlock pairs = random_pairs(size, 1e-3, has_large_turn, references, random);
      BlockMotion motion;
      measure_pairs(pairs, references.columns(), motion);
      for (std::size_t i = 0; i < size; ++i) {
        const ContactMotion one = particle_pair_motion(pairs.pair(i), references.columns()[i], pairs.discs(i));
        REQUIRE(motion.normal[i] == one.geometry.normal);
        REQUIRE(motion.arm_first[i] == one.geometry.arm_first);
        REQUIRE(motion.arm_second[i] == one.geometry.arm_second);
        REQUIRE(motion.opening[i] == one.opening);
        REQUIRE(motion.slip_increment[i] == one.slip_increment);
      }
    }
  }
}

TEST_CASE("contacts keep the openings of a block, and add up its slips") {
  RandomNumbers random(13);
  const std::size_t size = 101;
  BlockMotion motion;
  std::vector<double> opening(size, 0.0);
  std::vector<ShearVector> shear_displacement;
  for (std::size_t i = 0; i < size; ++i) {
    motion.set(i, {{}, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    shear_displacement.push_back(random.uniform(-1.0, 1.0));
  }
  const std::vector<ShearVector> before = shear_displacement;
  keep_motion(size, motion, opening.data(), shear_displacement.data());
  for (std::size_t i = 0; i < size; ++i) {
    REQUIRE(opening[i] == motion.opening[i]);
    REQUIRE(shear_displacement[i] == before[i] + motion.slip_increment[i]);
  }
}

TEST_CASE("forces at the ends of a block of pairs have the bits of those of pairs one by one") {
  RandomNumbers random(12);
  for (const std::size_t size : {1, 7, 64, 101, 128}) {
    CAPTURE(size);
    BlockMotion motion;
    BlockColumn<double> normal_force;
    BlockColumn<ShearVector> shear_force;
    for (std::size_t i = 0; i < size; ++i) {
      const ContactGeometry geometry{random.direction(), random.uniform(0.1, 1.0), random.uniform(0.1, 1.0)};
      motion.set(i, {geometry, 0.0, 0.0});
      normal_force[i] = random.uniform(-1e3, 1e3);
      shear_force[i] = random.uniform(-1e3, 1e3);
    }
    BlockEndForces<2> forces;
    find_pair_forces(size, motion, normal_force.data(), shear_force.data(), forces);
    for (std::size_t i = 0; i < size; ++i) {
      const ContactGeometry geometry = motion.geometry(i);
      const ContactPointForce force = contact_point_force(geometry.normal, normal_force[i], shear_force[i]);
      REQUIRE(forces.at(0, i).force == force_on_first(geometry, force).force);
      REQUIRE(forces.at(0, i).moment == force_on_first(geometry, force).moment);
      REQUIRE(forces.at(1, i).force == force_on_second(geometry, force).force);
      REQUIRE(forces.at(1, i).moment == force_on_second(geometry, force).moment);
    }
  }
}
