#include <doctest/doctest.h>

#include "mesh/element_forces.hpp"
#include "support/element_model.hpp"
#include "support/random_numbers.hpp"
#include "support/resting_state.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

Field<Vector> node_forces(ElementForces& forces, const Model& model, State state, int n_threads) {
  const SharedLoops shared(n_threads);
  forces.add_forces(model, state);
  return state.nodes.translation.force;
}

}  // namespace

TEST_SUITE_BEGIN("threads");

TEST_CASE("element forces: the same bits for every number of threads on one mesh after the other") {
  RandomNumbers random(3);
  ElementForces forces;
  for (const int n_columns : {30, 17}) {
    const Model model = element_model(
        build_structured_mesh({even_lines(0.0, 3.0, n_columns), even_lines(0.0, 2.0, 20)}, {}), {.poisson_ratio = 0.3});
    State state = resting_state(model);
    for (Vector& u : state.nodes.translation.displacement) u = random.vector(1.0);
    const Field<Vector> alone = node_forces(forces, model, state, 1);
    CHECK(alone != Field<Vector>(model.nodes.size()));
    for (const int n_threads : {2, 3, 8}) CHECK(node_forces(forces, model, state, n_threads) == alone);
  }
}

TEST_SUITE_END();
