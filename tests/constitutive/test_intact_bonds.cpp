#include <doctest/doctest.h>

#include "constitutive/batch_law.hpp"
#include "constitutive/intact_bonds.hpp"
#include "constitutive/mohr_coulomb_brittle.hpp"
#include "support/contact_batch_arrays.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr MohrCoulombBrittle point_law{{.tensile_strength = 1.8e5, .cohesion = 6.5e5, .friction_coefficient = 0.2}};

/// A batch in motion: intact bonds, some at their limits, some broken, some that have just touched.
ContactBatchArrays random_batch(const ConstitutiveLaw& law, std::size_t count, RandomNumbers& random) {
  ContactBatchArrays batch(law, count);
  for (std::size_t i = 0; i < count; ++i) {
    batch.opening[i] = random.uniform(-2e-6, 1.2e-6);
    batch.slip_increment[i] = random.uniform(-9e-6, 9e-6);
    batch.shear_force[i] = random.uniform(-3e3, 3e3);
    if (i % 17 == 3) batch.bond[i] = BondState::broken;
  }
  return batch;
}

}  // namespace

TEST_CASE("bonds that stay intact have the bits of their law, and the others are left as they were") {
  const BatchLaw<MohrCoulombBrittle> law(point_law);
  RandomNumbers random(7);
  for (const std::size_t count : {1, 3, 8, 61, 128}) {
    CAPTURE(count);
    ContactBatchArrays batch = random_batch(law, count, random);
    const ContactBatchArrays before = batch;
    LeftToLaw left{};
    const int n_left = carry_intact(point_law.intact_limits(),
                                    {batch.opening,
                                     batch.slip_increment,
                                     batch.normal_stiffness,
                                     batch.shear_stiffness,
                                     batch.area,
                                     batch.normal_force,
                                     batch.shear_force,
                                     batch.bond,
                                     {}},
                                    0, count, left);
    int n_not_intact = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const ContactInput input{before.opening[i], before.slip_increment[i], 2e9, 1e9, 0.01};
      ContactForce force{before.normal_force[i], before.shear_force[i], before.bond[i]};
      MohrCoulombBrittle::History history{};
      point_law.evaluate(input, force, history);
      const bool is_intact = force.bond == BondState::bonded;
      n_not_intact += is_intact ? 0 : 1;
      REQUIRE(left[i] == (is_intact ? 0 : 1));
      REQUIRE(batch.normal_force[i] == (is_intact ? force.normal : before.normal_force[i]));
      REQUIRE(batch.shear_force[i] == (is_intact ? force.shear : before.shear_force[i]));
    }
    CHECK(n_left == n_not_intact);
  }
}

TEST_CASE("a batch of intact and broken bonds is what the law makes of each") {
  const BatchLaw<MohrCoulombBrittle> law(point_law);
  RandomNumbers random(8);
  ContactBatchArrays batch = random_batch(law, 700, random);
  const ContactBatchArrays before = batch;
  batch.evaluate(law);
  for (std::size_t i = 0; i < 700; ++i) {
    ContactForce force{before.normal_force[i], before.shear_force[i], before.bond[i]};
    MohrCoulombBrittle::History history{};
    point_law.evaluate({before.opening[i], before.slip_increment[i], 2e9, 1e9, 0.01}, force, history);
    REQUIRE(batch.normal_force[i] == force.normal);
    REQUIRE(batch.shear_force[i] == force.shear);
    REQUIRE(batch.bond[i] == force.bond);
    for (std::size_t k = 0; k < history.size(); ++k) REQUIRE(batch.history[k][i] == history[k]);
  }
}
