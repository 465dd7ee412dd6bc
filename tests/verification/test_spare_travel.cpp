#include <doctest/doctest.h>

#include "build/build_simulation.hpp"
#include "core/state_hash.hpp"

using namespace ligament;

namespace {

Simulation simulation_of(const std::string& case_file) {
  Case input = read_case(std::string(LIGAMENT_SOURCE_DIR "/") + case_file, {});
  return std::move(build_simulation(input).simulation);
}

}  // namespace

TEST_CASE("a search that looks when bodies may have gone far enough finds what one finds that looks at every step") {
  for (const char* case_file : {"tests/restart/falling_block.toml", "tests/restart/beam_on_platens.toml"}) {
    CAPTURE(case_file);
    Simulation simulation = simulation_of(case_file);
    Simulation twin = simulation_of(case_file);
    for (int i = 0; i < 400; ++i) {
      simulation.step();
      // A state just restored has no history: how far bodies may have gone is not known.
      twin.restore(twin.state());
      twin.step();
    }
    CHECK(state_hash(simulation.state()) == state_hash(twin.state()));
    CHECK(simulation.state().search.n_updates == twin.state().search.n_updates);
  }
  Simulation falling = simulation_of("tests/restart/falling_block.toml");
  for (int i = 0; i < 400; ++i) falling.step();
  CHECK(falling.state().search.n_updates > 0);
}
