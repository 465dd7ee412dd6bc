#include <doctest/doctest.h>

#include <type_traits>
#include <vector>

#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "constitutive/mohr_coulomb_exponential.hpp"
#include "driven_bond.hpp"
#include "reference/softening_twin.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;
using namespace ligament::test;

#define SOFTENING_LAWS MohrCoulombBilinear, MohrCoulombExponential

namespace {

constexpr double tension_energy = 10.0 * 1e-4;
constexpr double shear_energy = 500.0 * 1e-4;

/// Changes of opening and slip.
struct Leg {
  double opened = 0.0;
  double slipped = 0.0;
};

/// Legs between random openings, half of them closed, with random slips, until about half of the strength is gone.
std::vector<Leg> random_path(RandomNumbers& random, int n_legs) {
  std::vector<Leg> path;
  double opening = 0.0;
  for (int i = 0; i < n_legs; ++i) {
    const double next = random.uniform(-5e-6, 5e-6);
    path.push_back({next - opening, random.uniform(-4e-5, 4e-5)});
    opening = next;
  }
  return path;
}

template <class Law>
void follow(DrivenBond<Law>& bond, const std::vector<Leg>& path, int n_steps) {
  for (const Leg& leg : path) {
    const double from = bond.opening;
    for (int i = 1; i <= n_steps; ++i) bond.step(from + leg.opened * i / n_steps, leg.slipped / n_steps);
  }
}

template <class Law>
std::vector<Law> variants() {
  std::vector<Law> laws;
  for (const auto coupling : {DamageCoupling::sum, DamageCoupling::largest, DamageCoupling::none}) {
    for (const auto unloading : {Unloading::secant, Unloading::elastic}) {
      laws.push_back(concrete<Law>());
      laws.back().coupling = coupling;
      laws.back().unloading = unloading;
    }
  }
  return laws;
}

/// Walks at random; the sizes of steps of a walk are drawn once.
template <class Law>
void walk(const Law& law, RandomNumbers& random, int n_steps, double& largest_defect) {
  DrivenBond<Law> bond(law);
  const double stride = random.uniform(0.02, 1.0);
  ContactEnergies before;
  double defect_before = 0.0;
  for (int i = 0; i < n_steps; ++i) {
    const double opened = stride * random.uniform(-1e-6, 1e-6) - 0.02 * bond.opening;
    const double slipped = stride * random.uniform(-2e-5, 2e-5);
    bond.step(bond.opening + opened, slipped);
    const ContactEnergies now = bond.energies();
    const double rounding = 1e-13 * (tension_energy + shear_energy);
    REQUIRE(now.fracture_tension >= before.fracture_tension - rounding);
    REQUIRE(now.fracture_shear >= before.fracture_shear - rounding);
    // Once broken it is that of the frictional law, with its own tests.
    if (bond.force.bond != BondState::broken) REQUIRE(now.friction >= before.friction - rounding);
    REQUIRE(now.fracture_tension <= tension_energy + rounding);
    // With coupled damages shear also spends what tension has stored and shear damage sets free.
    const double for_shear = shear_energy + (law.coupling == DamageCoupling::none ? 0.0 : tension_energy);
    REQUIRE(now.fracture_shear <= for_shear + rounding);
    REQUIRE(now.fracture_tension + now.fracture_shear <= tension_energy + shear_energy + rounding);
    REQUIRE(now.elastic_normal >= 0.0);
    REQUIRE(now.elastic_shear >= 0.0);

    const double d_t = bond.history[Law::damage_tension];
    const double d_s = bond.history[Law::damage_shear];
    const double limit = 1.8e6 * bond.area * strength_left(law.coupling, d_t, d_s);
    const double pressure = std::max(0.0, -bond.k_n * bond.opening);
    const double shear_limit = 6.5e6 * bond.area * strength_left(law.coupling, d_s, d_t) + 0.2 * pressure;
    REQUIRE(-bond.force.normal <= limit + 1e-9);
    REQUIRE(std::abs(bond.force.shear) <= shear_limit + 1e-9);

    const double scale = bond.k_n * opened * opened + bond.k_s * slipped * slipped;
    largest_defect = std::max(largest_defect, std::abs(bond.defect() - defect_before) / scale);
    defect_before = bond.defect();
    before = now;
  }
}

}  // namespace

TEST_CASE_TEMPLATE("walks at random: no mode gives energy back or spends more than it has, forces keep to their limits",
                   Law, SOFTENING_LAWS) {
  RandomNumbers random(41);
  double largest_defect = 0.0;
  for (const Law& law : variants<Law>()) {
    for (int i = 0; i < 90; ++i) walk(law, random, 1000, largest_defect);
  }
  // A step misses no more than the square of its length times the springs.
  CHECK(largest_defect < 1.0);
}

TEST_CASE_TEMPLATE("what is stored and spent is the work of the forces, to order 2 in the step, in mixed modes", Law,
                   SOFTENING_LAWS) {
  for (const Law& law : variants<Law>()) {
    RandomNumbers random(42);
    double coarse = 0.0;
    double fine = 0.0;
    double work = 0.0;
    for (int i = 0; i < 20; ++i) {
      const auto path = random_path(random, 10);
      DrivenBond<Law> bond(law);
      follow(bond, path, 100);
      DrivenBond<Law> slow(law);
      follow(slow, path, 1000);
      coarse += std::abs(bond.defect());
      fine += std::abs(slow.defect());
      work += slow.work;
    }
    CHECK(coarse < 1e-3 * work);
    CHECK(fine < 0.02 * coarse);
  }
}

TEST_CASE_TEMPLATE("sheared in part, then pulled apart: the ledger closes to order 2 through the break", Law,
                   SOFTENING_LAWS) {
  // Mean over paths whose kinks fall differently into the steps.
  const auto defect = [](const Law& law, int n_steps) {
    double sum = 0.0;
    for (int k = 0; k < 20; ++k) {
      DrivenBond<Law> bond(law);
      bond.slip_by((1.0 + 0.02 * k) * 3e-5, n_steps);
      bond.pull_to((1.0 + 0.02 * k) * 4e-5, n_steps);
      CHECK((bond.force.bond == BondState::broken) == (law.coupling != DamageCoupling::none));
      sum += std::abs(bond.defect());
    }
    return sum / 20.0;
  };
  for (const Law& law : variants<Law>()) {
    const double fine = defect(law, 4000);
    CHECK(fine < 1e-4 * tension_energy);
    CHECK(fine < 0.02 * defect(law, 400));
  }
}

TEST_CASE_TEMPLATE("what tension has stored and shear damage sets free counts as fracture in shear", Law,
                   SOFTENING_LAWS) {
  DrivenBond<Law> bond(concrete<Law>());
  bond.pull_to(3e-6, 10);
  bond.pull_to(1e-6, 10);
  const double before = bond.energies().fracture_tension;
  const double stored = bond.energies().elastic_normal;
  const double tension_damage = bond.history[Law::damage_tension];
  bond.slip_by(2e-5, 4000);
  CHECK(bond.energies().fracture_tension == doctest::Approx(before).epsilon(1e-12));
  const double set_free = stored - bond.energies().elastic_normal;
  CHECK(set_free > 0.2 * stored);
  // The rest is A ∫C (s - D_t) dw.
  const double w = bond.history[Law::slip_inelastic];
  const double x = w * 6.5e6 / 500.0;
  const double slipped = 1e-4 * (500.0 * bond.law.curve.area(x) - 6.5e6 * tension_damage * w);
  CHECK(bond.energies().fracture_shear - slipped == doctest::Approx(set_free).epsilon(1e-4));
}

TEST_CASE_TEMPLATE("pulled, unloaded, closed, pulled off, closed and pulled again: G_ft A in all, whatever the options",
                   Law, SOFTENING_LAWS) {
  for (const Law& law : variants<Law>()) {
    DrivenBond<Law> bond(law);
    // Opened a little further every time, and pressed in between.
    for (const double opening : {1e-6, 4e-6, -1e-6, 9e-6, 2e-6, 1.3e-5, -2e-6, 5e-5}) bond.pull_to(opening, 7);
    const ContactEnergies broken = bond.energies();
    CHECK(broken.fracture_tension == doctest::Approx(tension_energy).epsilon(1e-10));
    CHECK(broken.fracture_shear == 0.0);
    for (const double opening : {-3e-6, 6e-5, -1e-6, 0.0}) bond.pull_to(opening, 7);
    CHECK(bond.energies().fracture_tension == broken.fracture_tension);
    CHECK(bond.energies().spent() == broken.spent());
    CHECK(bond.energies().stored() == 0.0);
  }
}

TEST_CASE_TEMPLATE("sheared to and fro under pressure until it fails, and on: G_fc A in all, whatever the options", Law,
                   SOFTENING_LAWS) {
  for (const Law& law : variants<Law>()) {
    DrivenBond<Law> bond(law);
    bond.pull_to(-2e-6);
    for (const double slip : {2e-4, -1e-4, 5e-6, -5e-6, 3e-4, -2e-4}) bond.slip_by(slip, 7);
    CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-10));
    CHECK(bond.energies().fracture_tension == 0.0);
    const double friction = bond.energies().friction;
    bond.slip_by(1e-4, 7);
    CHECK(bond.energies().fracture_shear == doctest::Approx(shear_energy).epsilon(1e-10));
    CHECK(bond.energies().friction > friction);
  }
}

TEST_CASE_TEMPLATE("the bond does what a twin with tiny substeps does", Law, SOFTENING_LAWS) {
  constexpr auto law =
      std::is_same_v<Law, MohrCoulombBilinear> ? reference::one_fourth_law : reference::exponential_law;
  RandomNumbers random(43);
  double shear_error = 0.0;
  double normal_error = 0.0;
  double fracture_error = 0.0;
  double friction_error = 0.0;
  double largest_damage = 0.0;
  for (int i = 0; i < 20; ++i) {
    DrivenBond<Law> bond(concrete<Law>());
    reference::SofteningTwin twin{law, bond.k_n, bond.k_s, bond.area, 1.8e6, 6.5e6, 0.2, 10.0, 500.0};
    for (const Leg& leg : random_path(random, 10)) {
      follow(bond, {leg}, 400);
      twin.move(leg.opened, leg.slipped, 20000);
      normal_error = std::max(normal_error, std::abs(bond.force.normal - twin.normal));
      shear_error = std::max(shear_error, std::abs(bond.force.shear - twin.shear));
      const ContactEnergies energies = bond.energies();
      fracture_error =
          std::max(fracture_error, std::abs(energies.fracture_tension + energies.fracture_shear - twin.fracture()));
      friction_error = std::max(friction_error, std::abs(energies.friction - twin.friction_work));
      CHECK((bond.force.bond == BondState::broken) == (twin.damage == 1.0));
      if (twin.damage < 1.0) largest_damage = std::max(largest_damage, twin.damage);
    }
  }
  CHECK(largest_damage > 0.9);
  CHECK(normal_error < 1e-3 * 180.0);
  CHECK(shear_error < 1e-3 * 650.0);
  CHECK(fracture_error < 1e-3 * shear_energy);
  CHECK(friction_error < 1e-3 * shear_energy);
}
