#include <doctest/doctest.h>

#include "build/build_simulation.hpp"
#include "core/state_hash.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using support::SharedLoops;

namespace {

/// A case, what replaces its values, and how far it goes.
struct Trial {
  std::string case_file;
  std::vector<std::string> overrides;
  int n_steps = 100;
};

/// A case after its steps, or increments of loading.
struct Outcome {
  std::string hash;
  std::int64_t n_searches = 0;
};

Outcome outcome_of(const Trial& trial, int n_threads) {
  const SharedLoops shared(n_threads);
  Case input = read_case(std::string(LIGAMENT_SOURCE_DIR "/") + trial.case_file, trial.overrides);
  BuiltSimulation built = build_simulation(input);
  for (int i = 0; i < trial.n_steps; ++i) REQUIRE(built.simulation.advance());
  built.simulation.audit();
  return {state_hash(built.simulation.state()), built.simulation.state().search.n_updates};
}

void check_same_bits(const Trial& trial, bool contacts_change = false) {
  CAPTURE(trial.case_file);
  CAPTURE(trial.overrides);
  const Outcome alone = outcome_of(trial, 1);
  CHECK((alone.n_searches > 0) == contacts_change);
  for (const int n_threads : {2, 3, 8}) CHECK(outcome_of(trial, n_threads).hash == alone.hash);
}

}  // namespace

TEST_SUITE_BEGIN("threads");

TEST_CASE("elements with facets and corners: the same state for every number of threads") {
  check_same_bits({"config/column_hexagonal_h2.toml", {}});
}

TEST_CASE("contacts that come and go: the same state for every number of threads") {
  check_same_bits({"tests/restart/falling_block.toml", {}, 300}, true);
}

TEST_CASE("every damping: the same state for every number of threads") {
  for (const char* method : {"dynamic_relaxation", "local_damping", "two_level_relaxation", "undamped"}) {
    check_same_bits({"config/column_hexagonal_h2.toml", {std::string("solver.method=") + method}, 30});
  }
}

TEST_CASE("beams and platens: the same state for every number of threads") {
  check_same_bits({"tests/restart/beam_on_platens.toml", {}, 50});
}

TEST_CASE("increments in which bonds soften: the same state for every number of threads") {
  const std::string case_file = "tests/restart/tension.toml";
  for (const std::string law : {"mohr_coulomb_bilinear", "mohr_coulomb_exponential"}) {
    check_same_bits({case_file, {"material.concrete.law=" + law, "solver.increment=4 um"}, 2});
  }
  check_same_bits({case_file, {"solver.method=secant", "solver.control=opening", "solver.increment=2 um"}, 4});
}

TEST_SUITE_END();
