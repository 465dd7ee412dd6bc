#include <doctest/doctest.h>

#include <cstddef>

#include "core/state_hash.hpp"
#include "filled_state.hpp"

using namespace ligament;

namespace {

/// Turns over one bit of a number after the other; says whether the hash saw all, or none.
struct Seen {
  bool all = true;
  bool none = true;

  void note(bool changed) {
    all = all && changed;
    none = none && !changed;
  }
};

template <class T>
void flip_bits(T& number, const State& state, const std::string& hash, Seen& seen) {
  auto* bytes = reinterpret_cast<unsigned char*>(&number);
  for (std::size_t bit = 0; bit < 8 * sizeof(T); ++bit) {
    const auto mask = static_cast<unsigned char>(1u << (bit % 8));
    bytes[bit / 8] ^= mask;
    seen.note(state_hash(state) != hash);
    bytes[bit / 8] ^= mask;
  }
}

}  // namespace

TEST_CASE("the hash has 32 hexadecimal digits and follows from the state alone") {
  const std::string hash = state_hash(filled_state());
  CHECK(hash.size() == 32);
  CHECK(hash.find_first_not_of("0123456789abcdef") == std::string::npos);
  CHECK(state_hash(filled_state()) == hash);
  CHECK(state_hash(State{}) != hash);
}

TEST_CASE("every bit of the physics is in the hash, no sampled one is") {
  State state = filled_state();
  const std::string hash = state_hash(state);
  visit_fields(state, [&]<class T>(const std::string& name, T& field, FieldRole role) {
    CAPTURE(name);
    Seen seen;
    if constexpr (std::is_arithmetic_v<T>) {
      flip_bits(field, state, hash, seen);
    } else {
      for (auto& number : field) flip_bits(number, state, hash, seen);
    }
    CHECK((role == FieldRole::physics ? seen.all : seen.none));
  });
  CHECK(state_hash(state) == hash);
}

TEST_CASE("the two zeros differ") {
  State state = filled_state();
  state.particles.translation.velocity[0] = {0.0, 1.0};
  const std::string hash = state_hash(state);
  state.particles.translation.velocity[0] = {-0.0, 1.0};
  CHECK(state_hash(state) != hash);
}

TEST_CASE("where a field ends matters") {
  State one;
  one.nodes.translation.displacement.resize(2);
  State other;
  other.nodes.translation.displacement.resize(1);
  other.nodes.translation.increment.resize(1);
  CHECK(state_hash(one) != state_hash(other));
}
