#include <doctest/doctest.h>

#include "build/structure_pieces.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Breaks the bonds between particles where a condition on their rest positions says so.
template <class Condition>
State with_broken(const Model& model, State state, Condition condition) {
  ContactTable& contacts = state.particle_contacts;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    const Vector& first = model.particles.position[contacts.first[row]];
    const Vector& second = model.particles.position[contacts.second[row]];
    if (condition(first, second)) contacts.bond[row] = BondState::broken;
  }
  return state;
}

auto across(double x) {
  return [x](const Vector& a, const Vector& b) { return (a.x < x) != (b.x < x); };
}

}  // namespace

TEST_CASE("a row of discs falls into pieces: what comes off is all but the largest") {
  Model model = empty_model();
  for (int i = 0; i < 10; ++i) add_particle(model, {1.0 * i, 0.0}, 0.5);
  // A wall along the row holds no piece to another.
  add_wall(model, {9.5, 0.5}, {-0.5, 0.5}, {.is_tied = true});
  const Simulation simulation = make_simulation(std::move(model));
  const Model& row = simulation.model();
  const StructurePieces pieces(row, simulation.state());
  CHECK(pieces.largest_cut_off(row, simulation.state()) == 0.0);
  const State once = with_broken(row, simulation.state(), across(2.5));
  CHECK(pieces.largest_cut_off(row, once) == doctest::Approx(0.3).epsilon(1e-14));
  const State twice = with_broken(row, once, across(7.5));
  CHECK(pieces.largest_cut_off(row, twice) == doctest::Approx(0.3).epsilon(1e-14));
  const State loose = with_broken(row, simulation.state(), across(0.5));
  CHECK(pieces.largest_cut_off(row, loose) == doctest::Approx(0.1).epsilon(1e-14));
  // What was apart at first has not come off since.
  CHECK(StructurePieces(row, once).largest_cut_off(row, once) == 0.0);
  CHECK(StructurePieces(row, once).largest_cut_off(row, twice) == doctest::Approx(0.2).epsilon(1e-14));
}

TEST_CASE("softening bonds hold") {
  Model model = empty_model();
  for (int i = 0; i < 2; ++i) add_particle(model, {1.0 * i, 0.0}, 0.5);
  Simulation simulation = make_simulation(std::move(model));
  State state = simulation.state();
  const StructurePieces pieces(simulation.model(), state);
  state.particle_contacts.bond[0] = BondState::softening;
  CHECK(pieces.largest_cut_off(simulation.model(), state) == 0.0);
  state.particle_contacts.bond[0] = BondState::broken;
  CHECK(pieces.largest_cut_off(simulation.model(), state) == 0.5);
}
