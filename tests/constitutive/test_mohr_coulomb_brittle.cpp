#include <doctest/doctest.h>

#include "constitutive/mohr_coulomb_brittle.hpp"
#include "driven_bond.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;
using namespace ligament::test;

namespace {

using Bond = DrivenBond<MohrCoulombBrittle>;

Bond brittle_bond() { return Bond(MohrCoulombBrittle{{1.8e6, 6.5e6, 0.2}}); }

constexpr double tension_limit = 1.8e6 * Bond::area;
constexpr double shear_limit = 6.5e6 * Bond::area;

}  // namespace

TEST_CASE("a brittle bond carries σ_t A, then nothing, and spends what its spring had stored") {
  Bond bond = brittle_bond();
  bond.pull_to(0.9999999999999 * tension_limit / bond.k_n);
  CHECK(bond.force.bond == BondState::bonded);
  CHECK(-bond.force.normal == doctest::Approx(tension_limit).epsilon(1e-12));
  bond.pull_to(1.0000000000001 * tension_limit / bond.k_n);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.force.normal == 0.0);
  CHECK(bond.energies().stored() == 0.0);
  CHECK(bond.energies().fracture_tension ==
        doctest::Approx(0.5 * tension_limit * tension_limit / bond.k_n).epsilon(1e-12));
  CHECK(bond.energies().fracture_shear == 0.0);
  CHECK(bond.history[MohrCoulombBrittle::damage_tension] == 1.0);
}

TEST_CASE("a brittle bond under pressure carries C A + μ F_n, then μ F_n") {
  Bond bond = brittle_bond();
  const double friction = 0.2 * 400.0;
  bond.pull_to(-400.0 / bond.k_n);
  const double limit = shear_limit + friction;
  bond.slip_by(0.9999999999999 * limit / bond.k_s);
  CHECK(bond.force.bond == BondState::bonded);
  bond.slip_by(2e-13 * limit / bond.k_s);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.force.shear == doctest::Approx(-friction).epsilon(1e-14));
  CHECK(bond.force.normal == doctest::Approx(400.0).epsilon(1e-14));
  const ContactEnergies energies = bond.energies();
  CHECK(energies.fracture_shear == doctest::Approx(0.5 * shear_limit * shear_limit / bond.k_s).epsilon(1e-12));
  CHECK(energies.fracture_tension == 0.0);
  CHECK(energies.friction == doctest::Approx(friction * shear_limit / bond.k_s).epsilon(1e-12));
  CHECK(bond.history[MohrCoulombBrittle::damage_shear] == 1.0);
}

TEST_CASE("a bond that breaks in tension gives up its shear force, too, and tension takes the energy") {
  Bond bond = brittle_bond();
  bond.slip_by(0.5 * shear_limit / bond.k_s);
  bond.pull_to(0.9999999999999 * tension_limit / bond.k_n);
  const double stored = bond.energies().stored();
  bond.pull_to(1.0000000000001 * tension_limit / bond.k_n);
  CHECK(bond.force.shear == 0.0);
  CHECK(bond.energies().fracture_tension == doctest::Approx(stored).epsilon(1e-12));
  CHECK(bond.energies().fracture_shear == 0.0);
}

TEST_CASE("whatever the step that breaks it, a brittle bond spends what it has stored at its limit") {
  RandomNumbers random(51);
  int n_broken = 0;
  double defect = 0.0;
  double finer_defect = 0.0;
  for (int i = 0; i < 1000; ++i) {
    // Towards and beyond the limits on a straight line.
    const double opened = random.uniform(-2e-6, 2e-6);
    const double slipped = random.uniform(-2e-5, 2e-5);
    const auto led = [&](int n_steps) {
      Bond bond = brittle_bond();
      for (int step = 0; step < n_steps; ++step) bond.step(bond.opening + opened / n_steps, slipped / n_steps);
      return bond;
    };
    const Bond at_once = led(1);
    const Bond bond = led(100);
    const Bond finer = led(1000);
    const double fracture = bond.energies().fracture_tension + bond.energies().fracture_shear;
    REQUIRE(at_once.force.bond == bond.force.bond);
    REQUIRE(at_once.energies().fracture_tension == doctest::Approx(bond.energies().fracture_tension).epsilon(1e-9));
    REQUIRE(at_once.energies().fracture_shear == doctest::Approx(bond.energies().fracture_shear).epsilon(1e-9));
    REQUIRE(at_once.energies().friction == doctest::Approx(finer.energies().friction).epsilon(0.01));
    defect += std::abs(bond.defect());
    finer_defect += std::abs(finer.defect());
    n_broken += fracture > 0.0 ? 1 : 0;
  }
  CHECK(n_broken > 800);
  // The trapezoid of the step that breaks it misses the limit within the step.
  CHECK(finer_defect < 0.2 * defect);
}

TEST_CASE("a broken brittle bond that closes again feels k_n and friction only") {
  Bond bond = brittle_bond();
  bond.pull_to(2.0 * tension_limit / bond.k_n, 10);
  const double spent = bond.energies().fracture_tension;
  bond.pull_to(-1e-6, 10);
  bond.slip_by(1e-5, 10);
  CHECK(bond.force.normal == doctest::Approx(780.0).epsilon(1e-14));
  CHECK(bond.force.shear == doctest::Approx(-0.2 * 780.0).epsilon(1e-14));
  CHECK(bond.energies().fracture_tension == spent);
  CHECK(bond.force.bond == BondState::broken);
}

TEST_CASE("walks of a brittle bond at random: no fracture energy is given back, nothing stored is negative") {
  RandomNumbers random(52);
  for (int i = 0; i < 1000; ++i) {
    Bond bond = brittle_bond();
    double fracture = 0.0;
    for (int step = 0; step < 100; ++step) {
      bond.step(0.9 * bond.opening + random.uniform(-1e-7, 1e-7), random.uniform(-1e-6, 1e-6));
      const ContactEnergies energies = bond.energies();
      REQUIRE(energies.fracture_tension + energies.fracture_shear >= fracture);
      REQUIRE(energies.stored() >= 0.0);
      fracture = energies.fracture_tension + energies.fracture_shear;
    }
  }
}
