#include <doctest/doctest.h>

#include "integrator/freedom_columns.hpp"
#include "integrator/sparse_stiffness.hpp"
#include "support/hand_made_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Four discs, every freedom with a spring to the ground, every pair of neighbours with one between them.
struct Chain {
  Model model = empty_model();
  StiffnessSum sum;

  Chain() : sum(make_discs(model)) {
    const Index count = static_cast<Index>(sum.numbers().count());
    for (Index i = 0; i < count; ++i) sum.add_spring(std::vector<SpringTerm>{{i, 1.0}}, 1.0 + i);
    for (Index i = 0; i + 3 < count; ++i) sum.add_spring(std::vector<SpringTerm>{{i, -1.0}, {i + 3, 0.5}}, 10.0);
  }
  static StiffnessSum make_discs(Model& model) {
    for (int i = 0; i < 4; ++i) add_particle(model, {0.1 * i, 0.0}, 0.05);
    model.particles.free[2] = {0.0, 1.0};
    return StiffnessSum(model);
  }
};

void check_answers(const StiffnessSum& sum, const std::vector<double>& free, const SparseStiffness& matrix) {
  for (std::size_t at = 0; at < free.size(); ++at) {
    std::vector<double> force(free.size(), 0.0);
    force[at] = free[at];
    const std::vector<double> motion = matrix.solve(force);
    const std::vector<double> back = sum.times(motion);
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (free[i] == 0.0) {
        CHECK(motion[i] == 0.0);
      } else {
        CHECK(back[i] == doctest::Approx(force[i]).epsilon(1e-7));
      }
    }
  }
}

}  // namespace

TEST_CASE("the factorised stiffness answers forces with the motion that calls for them") {
  Chain chain;
  const std::vector<double> free = free_mask(chain.model);
  SparseStiffness matrix;
  matrix.factorise(chain.sum, free);
  check_answers(chain.sum, free, matrix);

  // Other values in the same places.
  std::vector<double> stiffness(chain.sum.n_springs());
  for (std::size_t i = 0; i < stiffness.size(); ++i) stiffness[i] = 2.0 + static_cast<double>(i % 3);
  chain.sum.set_stiffness(stiffness);
  matrix.factorise(chain.sum, free);
  check_answers(chain.sum, free, matrix);

  // One more place.
  chain.sum.add_spring(std::vector<SpringTerm>{{0, 1.0}, {11, 1.0}}, 7.0);
  matrix.factorise(chain.sum, free);
  check_answers(chain.sum, free, matrix);
}

TEST_CASE("a freedom that has lost its stiffness does not stop the others") {
  Chain chain;
  std::vector<double> stiffness(chain.sum.n_springs(), 1.0);
  // All springs of freedom 0.
  stiffness[0] = 0.0;
  stiffness[12] = 0.0;
  chain.sum.set_stiffness(stiffness);
  SparseStiffness matrix;
  matrix.factorise(chain.sum, free_mask(chain.model));
  std::vector<double> force(12, 0.0);
  force[4] = 1.0;
  const std::vector<double> motion = matrix.solve(force);
  CHECK(motion[0] == 0.0);
  CHECK(chain.sum.times(motion)[4] == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("halves of two answers multiply to the work of one force on the answer to the other") {
  Chain chain;
  const std::vector<double> free = free_mask(chain.model);
  SparseStiffness matrix;
  matrix.factorise(chain.sum, free);
  const std::vector<SpringTerm> few{{0, 1.0}, {4, -2.0}};
  std::vector<double> force(free.size(), 0.0);
  for (const SpringTerm& term : few) force[term.freedom] = term.factor;
  std::vector<double> other(free.size(), 0.0);
  other[3] = 3.0;
  other[10] = 1.0;
  const std::vector<double> half = matrix.half(other);
  const SparseStiffness::SparseHalf sparse = matrix.half(few);
  double work = 0.0;
  for (std::size_t k = 0; k < sparse.places.size(); ++k) work += sparse.values[k] * half[sparse.places[k]];
  CHECK(work == doctest::Approx(product(force, matrix.solve(other))));
  const std::vector<double> dense = matrix.half(force);
  for (std::size_t k = 0; k < sparse.places.size(); ++k) {
    CHECK(sparse.values[k] == doctest::Approx(dense[sparse.places[k]]));
  }
}
