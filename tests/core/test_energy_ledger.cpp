#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/energy_ledger.hpp"

using namespace ligament;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a path sum keeps what plain addition would lose") {
  PathSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  CHECK(sum.total() == 2.0);

  PathSum tenths;
  double plain = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    tenths.add(0.1);
    plain += 0.1;
  }
  CHECK(tenths.total() == doctest::Approx(1e5).epsilon(1e-15));
  CHECK(std::abs(plain - 1e5) > 1e-7);
}

TEST_CASE("the half of a step's work that lies ahead counts when the step is taken") {
  PathSum sum;
  sum.book(0.0, 3.0);
  CHECK(sum.total() == 0.0);
  sum.book(2.0, 5.0);
  CHECK(sum.total() == 5.0);
  sum.book(0.5, 0.0);
  CHECK(sum.total() == 10.5);
}

TEST_CASE("path sums are found by name") {
  EnergyLedger ledger;
  const Index damping = ledger.open("damping");
  const Index loads = ledger.open("applied_loads");
  CHECK(damping != loads);
  CHECK(ledger.open("damping") == damping);
  ledger[loads].add(2.5);
  CHECK(ledger.total("applied_loads") == 2.5);
  CHECK(ledger.total("damping") == 0.0);
  CHECK(ledger.total("friction") == 0.0);
}

TEST_CASE("energy found less energy brought in is the defect") {
  EnergyBalance balance;
  balance.add({"kinetic", EnergyKind::kinetic, 1.0});
  balance.add({"elastic", EnergyKind::elastic, 2.0});
  balance.add({"friction", EnergyKind::dissipated, 4.0});
  balance.add({"loads", EnergyKind::work, 8.0});
  CHECK(balance.defect() == -1.0);
}

TEST_CASE("the error of a balance is its defect over the largest energy so far") {
  EnergyLedger ledger;
  CHECK(ledger.audit({}) == 0.0);
  CHECK(ledger.audit({.kinetic = 1.0, .elastic = 3.0, .work = 4.0}) == 0.0);
  CHECK(ledger.audit({.kinetic = 0.5, .elastic = 0.0, .work = 0.0}) == 0.125);
  CHECK(ledger.audit({.kinetic = -8.0, .elastic = 0.0, .work = -8.0}) == 0.0);
  CHECK(ledger.scale == 8.0);
  CHECK(ledger.largest_error == 0.125);
}

TEST_CASE("a balance that is not a number never passes") {
  for (const EnergyBalance& broken : {EnergyBalance{.kinetic = not_a_number}, EnergyBalance{.elastic = not_a_number},
                                      EnergyBalance{.dissipated = not_a_number}, EnergyBalance{.work = not_a_number},
                                      EnergyBalance{.kinetic = std::numeric_limits<double>::infinity()}}) {
    EnergyLedger at_rest;
    CHECK_FALSE(at_rest.audit(broken) <= 1e300);
    CHECK_FALSE(at_rest.largest_error <= 1e300);

    EnergyLedger in_motion;
    in_motion.audit({.elastic = 1.0, .work = 1.0});
    CHECK_FALSE(in_motion.audit(broken) <= 1e300);
    in_motion.audit({.elastic = 1.0, .work = 1.0});
    CHECK_FALSE(in_motion.largest_error <= 1e300);
  }
}
