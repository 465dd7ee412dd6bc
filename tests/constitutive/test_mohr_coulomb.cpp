#include <doctest/doctest.h>

#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "constitutive/mohr_coulomb_exponential.hpp"
#include "driven_bond.hpp"

using namespace ligament;
using namespace ligament::test;

#define SOFTENING_LAWS MohrCoulombBilinear, MohrCoulombExponential

namespace {

/// G A of Table 4 (J), and the displacements at which nothing is left for sure (m).
constexpr double tension_energy = 10.0 * 1e-4;
constexpr double shear_energy = 500.0 * 1e-4;
constexpr double far_open = 8.0 * 10.0 / 1.8e6;
constexpr double far_slip = 8.0 * 500.0 / 6.5e6;

}  // namespace

TEST_CASE_TEMPLATE("a bond pulled apart carries σ_t A at most and spends G_ft A", Law, SOFTENING_LAWS) {
  for (const Unloading unloading : {Unloading::secant, Unloading::elastic}) {
    auto law = concrete<Law>();
    law.unloading = unloading;
    DrivenBond<Law> bond(law);
    const double limit = 1.8e6 * bond.area;
    bond.step(0.999999 * limit / bond.k_n, 0.0);
    CHECK(bond.force.bond == BondState::bonded);
    CHECK(-bond.force.normal == doctest::Approx(0.999999 * limit).epsilon(1e-14));
    bond.step(1.000001 * limit / bond.k_n, 0.0);
    CHECK(bond.force.bond == BondState::softening);
    CHECK(-bond.force.normal == doctest::Approx(limit).epsilon(1e-6));
    CHECK(-bond.force.normal < limit);
    bond.pull_to(far_open, 300);
    CHECK(bond.force.bond == BondState::broken);
    CHECK(bond.force.normal == 0.0);
    CHECK(bond.energies().stored() == 0.0);
    CHECK(bond.energies().fracture_tension == doctest::Approx(tension_energy).epsilon(1e-14));
    CHECK(bond.energies().fracture_shear == 0.0);
    CHECK(bond.energies().friction == 0.0);
  }
}

TEST_CASE_TEMPLATE("a bond sheared off carries C A at most and spends G_fc A", Law, SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  const double limit = 6.5e6 * bond.area;
  bond.slip_by(1.000001 * limit / bond.k_s);
  CHECK(bond.force.bond == BondState::softening);
  CHECK(-bond.force.shear == doctest::Approx(limit).epsilon(1e-6));
  bond.slip_by(far_slip, 300);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.force.shear == 0.0);
  CHECK(bond.energies().stored() == 0.0);
  CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-14));
  CHECK(bond.energies().fracture_tension == 0.0);
}

TEST_CASE_TEMPLATE("under pressure the peak of shear is C A + μ F_n, and what is left is μ F_n", Law, SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  const double pressure = 400.0;
  bond.step(-pressure / bond.k_n, 0.0);
  const double limit = 6.5e6 * bond.area + 0.2 * pressure;
  bond.slip_by(-0.9999999 * limit / bond.k_s);
  CHECK(bond.force.bond == BondState::bonded);
  CHECK(bond.force.shear == doctest::Approx(limit).epsilon(1e-6));
  bond.slip_by(-far_slip, 400);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.force.normal == doctest::Approx(pressure).epsilon(1e-14));
  CHECK(bond.force.shear == doctest::Approx(0.2 * pressure).epsilon(1e-14));
  CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-14));
  // μ F_n times the slip that the spring has not kept, up to the kink at the peak.
  const double slip = 0.9999999 * limit / bond.k_s + far_slip - 0.2 * pressure / bond.k_s;
  CHECK(bond.energies().friction == doctest::Approx(0.2 * pressure * slip).epsilon(1e-12));
  CHECK(std::abs(bond.defect()) < 1e-3 * bond.work);
}

TEST_CASE_TEMPLATE("the work of the forces converges to the closed form with order 2", Law, SOFTENING_LAWS) {
  const auto error = [](bool in_tension, int n_steps) {
    // Mean over paths whose kinks fall differently into the steps.
    double sum = 0.0;
    for (int k = 0; k < 20; ++k) {
      DrivenBond<Law> bond(concrete<Law>());
      if (in_tension) {
        bond.pull_to((1.0 + 0.01 * k) * far_open, n_steps);
      } else {
        bond.slip_by((1.0 + 0.01 * k) * far_slip, n_steps);
      }
      sum += std::abs(bond.defect());
    }
    return sum / (20.0 * (in_tension ? tension_energy : shear_energy));
  };
  for (const bool in_tension : {true, false}) {
    CHECK(error(in_tension, 4000) < 2e-5);
    CHECK(error(in_tension, 4000) < 0.02 * error(in_tension, 400));
  }
}

TEST_CASE_TEMPLATE("one step to the end is as good as many", Law, SOFTENING_LAWS) {
  for (const double part : {0.02, 0.1, 0.3, 0.6, 1.0}) {
    DrivenBond<Law> one(concrete<Law>());
    DrivenBond<Law> many(concrete<Law>());
    one.pull_to(part * far_open);
    many.pull_to(part * far_open, 777);
    CHECK(one.force.normal == doctest::Approx(many.force.normal).epsilon(1e-12));
    CHECK(one.energies().spent() == doctest::Approx(many.energies().spent()).epsilon(1e-12));
    DrivenBond<Law> one_slip(concrete<Law>());
    DrivenBond<Law> many_slips(concrete<Law>());
    one_slip.slip_by(part * far_slip);
    many_slips.slip_by(part * far_slip, 777);
    CHECK(one_slip.force.shear == doctest::Approx(many_slips.force.shear).epsilon(1e-12));
    CHECK(one_slip.energies().spent() == doctest::Approx(many_slips.energies().spent()).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("unloaded in tension a bond goes straight to its reference gap and back, and spends nothing", Law,
                   SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.pull_to(0.2 * far_open, 50);
  const double spent = bond.energies().spent();
  const double force = bond.force.normal;
  const double work = bond.work;
  CHECK(spent > 0.0);
  bond.pull_to(0.1 * far_open);
  CHECK(bond.force.normal == doctest::Approx(0.5 * force).epsilon(1e-14));
  CHECK(bond.energies().stored() == doctest::Approx(0.25 * 0.5 * -force * 0.2 * far_open).epsilon(1e-14));
  bond.pull_to(0.0, 10);
  CHECK(bond.force.normal == 0.0);
  bond.pull_to(-1e-6, 10);
  CHECK(bond.force.normal == doctest::Approx(1e-6 * bond.k_n).epsilon(1e-14));
  bond.pull_to(0.0, 10);
  bond.pull_to(0.2 * far_open, 10);
  CHECK(bond.force.normal == doctest::Approx(force).epsilon(1e-13));
  CHECK(bond.energies().spent() == doctest::Approx(spent).epsilon(1e-13));
  CHECK(bond.work == doctest::Approx(work).epsilon(1e-12));
  bond.pull_to(far_open, 100);
  CHECK(bond.energies().spent() == doctest::Approx(tension_energy).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("with elastic unloading the opening stays, and no force is needed to close it", Law,
                   SOFTENING_LAWS) {
  auto law = concrete<Law>();
  law.unloading = Unloading::elastic;
  DrivenBond<Law> bond(law);
  bond.pull_to(0.2 * far_open, 50);
  const double spent = bond.energies().spent();
  const double force = bond.force.normal;
  const double opening = bond.opening;
  bond.step(opening + 0.5 * force / bond.k_n, 0.0);
  CHECK(bond.force.normal == doctest::Approx(0.5 * force).epsilon(1e-12));
  bond.step(opening + 1.5 * force / bond.k_n, 0.0);
  CHECK(bond.force.normal == 0.0);
  bond.step(-1e-6, 0.0);
  CHECK(bond.force.normal == doctest::Approx(1e-6 * bond.k_n).epsilon(1e-14));
  bond.step(0.0, 0.0);
  bond.step(opening, 0.0);
  CHECK(bond.force.normal == doctest::Approx(force).epsilon(1e-12));
  CHECK(bond.energies().spent() == doctest::Approx(spent).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("cycles of shear unload along k_s, spend nothing below the limit and G_fc A in all", Law,
                   SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.slip_by(0.1 * far_slip, 20);
  const double spent = bond.energies().spent();
  const double force = bond.force.shear;
  bond.slip_by(1.9 * force / bond.k_s, 7);
  CHECK(bond.force.shear == doctest::Approx(-0.9 * force).epsilon(1e-12));
  CHECK(bond.energies().spent() == doctest::Approx(spent).epsilon(1e-14));
  // The strength is one, whichever way the bond slips.
  for (int cycle = 0; cycle < 60; ++cycle) bond.slip_by((cycle % 2 == 0 ? -0.1 : 0.1) * far_slip, 20);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("a broken bond that closes again feels k_n and friction only", Law, SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.pull_to(far_open, 100);
  bond.slip_by(3e-6);
  CHECK(bond.force.shear == 0.0);
  bond.pull_to(-1e-6, 10);
  CHECK(bond.force.normal == doctest::Approx(780.0).epsilon(1e-14));
  CHECK(bond.force.bond == BondState::broken);
  bond.slip_by(1e-5, 10);
  CHECK(bond.force.shear == doctest::Approx(-0.2 * 780.0).epsilon(1e-14));
  CHECK(bond.energies().friction > 0.0);
  CHECK(bond.energies().fracture_shear == 0.0);
  bond.pull_to(1e-6);
  CHECK(bond.force.normal == 0.0);
  CHECK(bond.force.shear == 0.0);
  CHECK(bond.energies().fracture_tension == doctest::Approx(tension_energy).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("damage of one mode weakens the other as the coupling says", Law, SOFTENING_LAWS) {
  const auto shear_strength_after_pull = [](DamageCoupling coupling) {
    auto law = concrete<Law>();
    law.coupling = coupling;
    DrivenBond<Law> bond(law);
    bond.pull_to(0.05 * far_open, 20);
    const double damage = bond.history[Law::damage_tension];
    CHECK(damage > 0.2);
    CHECK(damage < 0.6);
    bond.pull_to(0.0);
    const double limit = 6.5e6 * bond.area;
    bond.slip_by((1.0 - damage) * limit / bond.k_s * 1.001);
    return std::pair(-bond.force.shear / limit, 1.0 - damage);
  };
  for (const DamageCoupling coupling : {DamageCoupling::sum, DamageCoupling::largest}) {
    const auto strength = shear_strength_after_pull(coupling);
    CHECK(strength.first == doctest::Approx(strength.second).epsilon(1e-3));
  }
  // Not at its limit yet.
  const auto strength = shear_strength_after_pull(DamageCoupling::none);
  CHECK(strength.first == doctest::Approx(1.001 * strength.second).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("pulled and sheared in one step, both limits and both inelastic displacements fit together", Law,
                   SOFTENING_LAWS) {
  for (const auto coupling : {DamageCoupling::sum, DamageCoupling::largest, DamageCoupling::none}) {
    auto law = concrete<Law>();
    law.coupling = coupling;
    DrivenBond<Law> bond(law);
    bond.step(2e-6, 2e-5);
    CHECK(bond.force.bond == BondState::softening);
    const double d_t = bond.history[Law::damage_tension];
    const double d_s = bond.history[Law::damage_shear];
    CHECK(d_t > 0.2);
    CHECK(d_s > 0.1);
    const double tension = 1.8e6 * bond.area * strength_left(coupling, d_t, d_s);
    const double shear = 6.5e6 * bond.area * strength_left(coupling, d_s, d_t);
    CHECK(-bond.force.normal == doctest::Approx(tension).epsilon(1e-12));
    CHECK(-bond.force.shear == doctest::Approx(shear).epsilon(1e-12));
    CHECK(bond.history[Law::opening_inelastic] + tension / bond.k_n == doctest::Approx(2e-6).epsilon(1e-12));
    CHECK(bond.history[Law::slip_inelastic] + shear / bond.k_s == doctest::Approx(2e-5).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("a bond breaks where the damages add up to 1, however far the step goes", Law, SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.slip_by(0.05 * far_slip, 10);
  bond.step(100.0 * far_open, 100.0 * far_slip);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.history[Law::damage_tension] + bond.history[Law::damage_shear] == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("the break belongs to the mode that has the larger damage", Law, SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.slip_by(0.03 * far_slip, 20);
  const double shear_damage = bond.history[Law::damage_shear];
  CHECK(shear_damage > 0.1);
  CHECK(shear_damage < 0.4);
  bond.pull_to(far_open, 100);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.history[Law::damage_tension] > bond.history[Law::damage_shear]);
  CHECK(bond.force.shear == 0.0);
}

TEST_CASE_TEMPLATE("without coupling each mode has its own energy to spend", Law, SOFTENING_LAWS) {
  auto law = concrete<Law>();
  law.coupling = DamageCoupling::none;
  DrivenBond<Law> bond(law);
  bond.pull_to(far_open, 100);
  CHECK(bond.force.bond == BondState::softening);
  bond.slip_by(far_slip, 100);
  CHECK(bond.force.bond == BondState::broken);
  CHECK(bond.energies().fracture_tension == doctest::Approx(tension_energy).epsilon(1e-14));
  CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("a bond that would snap back is refused, with the least energy that would do", Law, SOFTENING_LAWS) {
  auto law = concrete<Law>();
  const ContactSample contact{7.8e8, 2.9e8, 1e-4};
  CHECK_FALSE(law.complaint(contact).has_value());
  const double least_in_tension = 1.8e6 * 1.8e6 * 1e-4 / 7.8e8;
  law.fracture_energy_tension = 1.000001 * least_in_tension;
  CHECK_FALSE(law.complaint(contact).has_value());
  law.fracture_energy_tension = 0.5 * least_in_tension;
  auto complaint = law.complaint(contact);
  REQUIRE(complaint.has_value());
  CHECK(complaint->severity == doctest::Approx(2.0).epsilon(1e-14));
  CHECK(complaint->text.find("'fracture_energy_tension' is 0.2077 J/m2, but a contact needs at least 0.4154 J/m2") ==
        0);
  law.fracture_energy_shear = 0.25 * 6.5e6 * 6.5e6 * 1e-4 / 2.9e8;
  complaint = law.complaint(contact);
  REQUIRE(complaint.has_value());
  CHECK(complaint->severity == doctest::Approx(4.0).epsilon(1e-14));
  CHECK(complaint->parameter == "fracture_energy_shear");
}
