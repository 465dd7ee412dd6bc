#include <doctest/doctest.h>

#include "integrator/freedom_columns.hpp"
#include "integrator/spring_flexibility.hpp"
#include "support/hand_made_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Five discs; freedoms with springs to the ground, and between neighbours.
StiffnessSum springs_of(Model& model) {
  for (int i = 0; i < 5; ++i) add_particle(model, {0.1 * i, 0.0}, 0.05);
  model.particles.free[2] = {0.0, 1.0};
  StiffnessSum sum(model);
  const auto count = static_cast<Index>(sum.numbers().count());
  for (Index i = 0; i < count; ++i) sum.add_spring(std::vector<SpringTerm>{{i, 1.0}}, 1.0 + i);
  for (Index i = 0; i + 3 < count; ++i) sum.add_spring(std::vector<SpringTerm>{{i, -1.0}, {i + 3, 0.5}}, 10.0);
  return sum;
}

}  // namespace

TEST_CASE("springs give way to each other as the factorised stiffness says, whatever the order of asking") {
  Model model = empty_model();
  const StiffnessSum sum = springs_of(model);
  const std::vector<double> free = free_mask(model);
  SpringFlexibility flexibility;
  flexibility.factorise(sum, free);
  const std::vector<std::size_t> springs{20, 3, 17, 0, 25, 9, 4, 11, 22, 15};
  const std::vector<double> all = flexibility.between(springs);
  for (std::size_t j = 0; j < springs.size(); ++j) {
    std::vector<double> pull(free.size(), 0.0);
    for (const SpringTerm& term : sum.spring(springs[j]).terms) {
      pull[term.freedom] = free[term.freedom] * term.factor;
    }
    const std::vector<double> motion = flexibility.matrix().solve(pull);
    const std::vector<double> half = flexibility.matrix().half(pull);
    for (std::size_t i = 0; i < springs.size(); ++i) {
      CHECK(all[i * springs.size() + j] == doctest::Approx(flexibility.stretch(springs[i], motion)).epsilon(1e-9));
      CHECK(flexibility.response(springs[i], half) ==
            doctest::Approx(flexibility.stretch(springs[i], motion)).epsilon(1e-9));
    }
  }

  SpringFlexibility other;
  other.factorise(sum, free);
  for (const std::size_t spring : {4, 25, 0, 22}) static_cast<void>(other.between({spring}));
  CHECK(other.between(springs) == all);
}
