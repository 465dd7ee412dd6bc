#include <doctest/doctest.h>

#include <algorithm>

#include "integrator/spring_equilibrium.hpp"

using namespace ligament;

namespace {

constexpr double stiffness = 4.0;
constexpr double softening = -0.5;
constexpr double limit = 1.0;

/// Normal springs that soften in a straight line beyond their limit; shear springs that stay as they are.
SpringAnswer soften(const SpringPair& stretch) {
  const double peak = limit / stiffness;
  const double pull =
      stretch[0] <= peak ? stiffness * stretch[0] : std::max(0.0, limit + softening * (stretch[0] - peak));
  return {{pull, stiffness * stretch[1]}, {stretch[0] <= peak ? stiffness : pull / stretch[0], stiffness}};
}

/// One contact that a spring of the structure, of this flexibility, pulls open.
SpringProblem one_contact(double aim, double flexibility) {
  return {.reference = {stiffness, stiffness},
          .stretch = {0.0, 0.0},
          .pull = {0.0, 0.0},
          .aim = {aim, 0.1},
          // Less what the contact itself makes stiffer.
          .flexibility = {flexibility / (1.0 + stiffness * flexibility), 0.0, 0.0, 0.1},
          .answer = [](std::size_t, const SpringPair& stretch) { return soften(stretch); }};
}

}  // namespace

TEST_CASE("springs that keep to the stiffness of the structure have nothing to add") {
  const auto excess = solve_springs(one_contact(0.2, 1.0), 1e-9);
  REQUIRE(excess);
  CHECK(excess->at(0) == 0.0);
  CHECK(excess->at(1) == 0.0);
}

TEST_CASE("a spring that softens comes to the stretch at which it and the structure pull the same") {
  const double flexibility = 1.0;
  const double aim = 0.4;
  const SpringProblem problem = one_contact(aim, flexibility);
  const auto excess = solve_springs(problem, 1e-9);
  REQUIRE(excess);
  const double stretch = aim - problem.flexibility[0] * excess->at(0);
  // (whole - e)/flexibility = limit + softening (e - peak), with `whole` from k e = (whole - e)/flexibility at the aim.
  const double whole = aim * (1.0 + stiffness * flexibility);
  const double peak = limit / stiffness;
  const double expected = (whole / flexibility - limit + softening * peak) / (1.0 / flexibility + softening);
  REQUIRE(expected < peak - limit / softening);
  CHECK(stretch == doctest::Approx(expected));
}

TEST_CASE("a spring that the structure tears open has no force left") {
  const SpringProblem problem = one_contact(2.0, 10.0);
  const auto excess = solve_springs(problem, 1e-9);
  REQUIRE(excess);
  CHECK(2.0 - problem.flexibility[0] * excess->at(0) == doctest::Approx(2.0 * (1.0 + stiffness * 10.0)));
}
