#include <doctest/doctest.h>

#include <vector>

#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "constitutive/mohr_coulomb_exponential.hpp"
#include "constitutive/strides.hpp"
#include "driven_bond.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;
using namespace ligament::test;

namespace {

constexpr double parts_to_the_end = 512.0;

/// How many strides are tried on a way with bumps in these parts.
int n_tries(double n_parts, const std::vector<double>& bumps) {
  int n = 0;
  double done = 0.0;
  walk_in_strides(n_parts, [&](double from, double to) {
    ++n;
    REQUIRE(from == done);
    REQUIRE(to >= from + 1.0);
    REQUIRE(to <= n_parts);
    for (const double bump : bumps) {
      if (bump < from || bump >= to) continue;
      if (to > from + 1.0) return Stride::refused;
      done = to;
      return Stride::uneven;
    }
    done = to;
    return Stride::even;
  });
  REQUIRE(done == n_parts);
  return n;
}

/// The same way, part by part.
template <class Law>
void go_in_parts(DrivenBond<Law>& bond, double opening, double slip) {
  const double way = std::max(std::abs(opening - bond.opening) / (5.0 * 10.0 / 1.8e6), std::abs(slip) / 385e-6);
  const double n_parts = std::ceil(3.0 * parts_to_the_end * way);
  const double from = bond.opening;
  for (double i = 1.0; i <= n_parts; i += 1.0) bond.step(from + (opening - from) * (i / n_parts), slip / n_parts);
}

}  // namespace

TEST_CASE("a way without bumps is one stride, and a bump is found by halving") {
  CHECK(n_tries(1.0, {}) == 1);
  CHECK(n_tries(2048.0, {}) == 1);
  CHECK(n_tries(2048.0, {0.0}) <= 24);
  CHECK(n_tries(2048.0, {1234.0}) <= 45);
  CHECK(n_tries(777.0, {100.0, 500.0}) <= 80);
}

TEST_CASE("rough ground is taken part by part, with little more than one try each") {
  std::vector<double> everywhere(512);
  for (std::size_t i = 0; i < everywhere.size(); ++i) everywhere[i] = static_cast<double>(i);
  CHECK(n_tries(512.0, everywhere) <= 512 + 10);
}

TEST_CASE_TEMPLATE("a long way in strides ends like the same way part by part", Law, MohrCoulombBilinear,
                   MohrCoulombExponential) {
  RandomNumbers random(11);
  for (int path = 0; path < 300; ++path) {
    CAPTURE(path);
    Law law = concrete<Law>();
    law.coupling = path % 3 == 0 ? DamageCoupling::largest : DamageCoupling::sum;
    DrivenBond<Law> strides(law);
    DrivenBond<Law> parts(law);
    // A broken contact slides all the way at once.
    for (int leg = 0; leg < 4 && strides.force.bond != BondState::broken; ++leg) {
      const double opening = random.uniform(-4e-6, 8e-6);
      const double slip = random.uniform(-6e-5, 6e-5);
      strides.step(opening, slip);
      go_in_parts(parts, opening, slip);
    }
    const double energy = parts.energies().spent() + parts.energies().stored();
    REQUIRE(strides.force.normal == doctest::Approx(parts.force.normal).epsilon(1e-2).scale(10.0));
    REQUIRE(strides.force.shear == doctest::Approx(parts.force.shear).epsilon(1e-2).scale(10.0));
    REQUIRE(strides.energies().spent() + strides.energies().stored() == doctest::Approx(energy).epsilon(1e-3));
  }
}

TEST_CASE_TEMPLATE("where a law keeps its history, many small steps do, too", Law, MohrCoulombBilinear,
                   MohrCoulombExponential) {
  RandomNumbers random(12);
  int n_kept = 0;
  DrivenBond<Law> bond(concrete<Law>());
  for (int i = 0; i < 4000; ++i) {
    if (i % 40 == 0) bond = DrivenBond<Law>(concrete<Law>());
    const double opening = random.uniform(-1e-6, 1.5e-6);
    const double slip = random.uniform(-2e-6, 2e-6);
    DrivenBond<Law> small = bond;
    ContactForce force = bond.force;
    bond.opening = opening;
    const bool keeps = bond.law.keeps_history(bond.input(slip), force, [&](auto k) { return bond.history[k]; });
    bond.opening = small.opening;
    bond.step(opening, slip);
    if (!keeps) continue;
    ++n_kept;
    REQUIRE(bond.history == small.history);
    const double from = small.opening;
    for (int part = 1; part <= 20; ++part) small.step(from + (opening - from) * part / 20, slip / 20);
    for (std::size_t k = 0; k < small.history.size(); ++k) {
      REQUIRE(small.history[k] == doctest::Approx(bond.history[k]).epsilon(1e-12).scale(1e-12));
    }
    REQUIRE(small.force.normal == doctest::Approx(force.normal).epsilon(1e-9).scale(1.0));
    REQUIRE(small.force.shear == doctest::Approx(force.shear).epsilon(1e-9).scale(1.0));
  }
  CHECK(n_kept > 400);
}
