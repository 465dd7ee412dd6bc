#include <doctest/doctest.h>

#include "constitutive/batch_law.hpp"
#include "constitutive/linear_elastic.hpp"
#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "constitutive/mohr_coulomb_brittle.hpp"
#include "constitutive/mohr_coulomb_exponential.hpp"
#include "driven_bond.hpp"

using namespace ligament;
using namespace ligament::test;

namespace {

/// Displacements (m) at which nothing is left for sure.
constexpr double far_open = 8.0 * 10.0 / 1.8e6;
constexpr double far_slip = 8.0 * 500.0 / 6.5e6;

template <class Law>
ContactDamage damage_of(const DrivenBond<Law>& bond) {
  return BatchLaw<Law>(bond.law).damage(bond.history);
}

template <class Law>
Law some_law() {
  return concrete<Law>();
}
template <>
MohrCoulombBrittle some_law() {
  MohrCoulombBrittle law;
  law.tensile_strength = 1.8e6;
  law.cohesion = 6.5e6;
  return law;
}

}  // namespace

TEST_CASE_TEMPLATE("damage grows from 0 to 1, in the mode in which the bond is led", Law, MohrCoulombBilinear,
                   MohrCoulombExponential, MohrCoulombBrittle) {
  DrivenBond<Law> pulled(some_law<Law>());
  pulled.pull_to(1e-8);
  CHECK(damage_of(pulled).value == 0.0);
  CHECK(damage_of(pulled).mode == FractureMode::none);
  pulled.pull_to(far_open, 300);
  CHECK(damage_of(pulled).value == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(damage_of(pulled).mode == FractureMode::tension);

  DrivenBond<Law> sheared(some_law<Law>());
  sheared.slip_by(far_slip, 300);
  CHECK(damage_of(sheared).value == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(damage_of(sheared).mode == FractureMode::shear);
}

TEST_CASE("halfway to the kink of the bilinear curve the damage is half of that at the kink") {
  DrivenBond<MohrCoulombBilinear> bond(concrete<MohrCoulombBilinear>());
  // w at half of 0.75 G/f, where the strength is (1 + 1/4) / 2 of f; with the opening of the spring at that force.
  const double strength = 0.625 * 1.8e6;
  bond.pull_to(0.375 * 10.0 / 1.8e6 + strength * bond.area / bond.k_n, 200);
  CHECK(damage_of(bond).value == doctest::Approx(0.375).epsilon(1e-9));
}

TEST_CASE("the modes are combined as their strengths are, and the larger one gives its name") {
  const ContactDamage sum = combined_damage(DamageCoupling::sum, 0.25, 0.5);
  CHECK(sum.value == 0.75);
  CHECK(sum.mode == FractureMode::shear);
  CHECK(combined_damage(DamageCoupling::sum, 0.75, 0.5).value == 1.0);
  CHECK(combined_damage(DamageCoupling::sum, 0.75, 0.5).mode == FractureMode::tension);
  CHECK(combined_damage(DamageCoupling::largest, 0.25, 0.5).value == 0.5);
  CHECK(combined_damage(DamageCoupling::none, 0.25, 0.5).value == 0.5);
  CHECK(combined_damage(DamageCoupling::sum, 0.0, 0.0).mode == FractureMode::none);
}

TEST_CASE("a law that tells nothing of damage has none") {
  CHECK(BatchLaw<LinearElastic>().damage({}).value == 0.0);
  CHECK(BatchLaw<LinearElastic>().damage({}).mode == FractureMode::none);
}
