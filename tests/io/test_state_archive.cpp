#include <doctest/doctest.h>

#include <string>

#include "core/error.hpp"
#include "core/state_hash.hpp"
#include "io/state_archive.hpp"

namespace ligament {
namespace {

State some_state() {
  State state;
  state.clock.step = 7;
  state.particles.translation.displacement = {{1.0, 2.0}, {3.0, 4.0}};
  state.nodes.translation.force = {{5.0, 6.0}};
  return state;
}

TEST_CASE("an archive reads back to the same bits, whatever memory it was written to") {
  const State state = some_state();
  const std::string archive = save_state(state);
  CHECK(save_state(state, std::string(100'000, 'x')) == archive);
  const State read = load_unknown_state(archive, array_lengths(state));
  CHECK(read.clock.step == 7);
  CHECK(state_hash(read) == state_hash(state));
}

TEST_CASE("an archive with another signature is refused before its length is believed") {
  const State state = some_state();
  std::string archive = save_state(state);
  archive[4] = '\x7f';  // of the eight bytes with the length of the signature
  CHECK_THROWS_WITH_AS(load_unknown_state(archive, array_lengths(state)),
                       "the archive of the checkpoint begins as no archive", FileError);
  CHECK_THROWS_AS(load_unknown_state("", array_lengths(state)), FileError);
}

}  // namespace
}  // namespace ligament
