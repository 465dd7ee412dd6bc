#include <doctest/doctest.h>

#include "build/build_simulation.hpp"
#include "core/state_hash.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using support::SharedLoops;

namespace {

/// A case after so many steps.
struct Outcome {
  std::string hash;
  std::int64_t n_searches = 0;
};

Outcome outcome_of(const std::string& case_file, int n_steps, int n_threads) {
  const SharedLoops shared(n_threads);
  Case input = read_case(std::string(LIGAMENT_SOURCE_DIR "/") + case_file, {});
  BuiltSimulation built = build_simulation(input);
  for (int i = 0; i < n_steps; ++i) built.simulation.step();
  built.simulation.audit();
  return {state_hash(built.simulation.state()), built.simulation.state().search.n_updates};
}

void check_same_bits(const std::string& case_file, int n_steps, bool contacts_change) {
  const Outcome alone = outcome_of(case_file, n_steps, 1);
  CHECK((alone.n_searches > 0) == contacts_change);
  for (const int n_threads : {2, 3, 8}) CHECK(outcome_of(case_file, n_steps, n_threads).hash == alone.hash);
}

}  // namespace

TEST_CASE("elements, facets and corners: the same state for every number of threads") {
  check_same_bits("config/column_hexagonal_h2.toml", 100, false);
}

TEST_CASE("contacts that come and go: the same state for every number of threads") {
  check_same_bits("tests/restart/falling_block.toml", 300, true);
}
