#include <doctest/doctest.h>

#include "integrator/gravity.hpp"
#include "integrator/loads.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

Model bodies() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  add_particle(model, {1.0, 0.0}, 0.25);
  add_node(model, {2.0, 0.0});
  return model;
}

}  // namespace

TEST_CASE("loads act on their body, risen linearly with time") {
  const Model model = bodies();
  AppliedLoads loads({{.body = PointLoad::Body::node, .row = 0, .force = {4.0, 2.0}, .rise_time = 8.0},
                      {.body = PointLoad::Body::particle, .row = 1, .force = {0.0, 3.0}, .moment = 5.0}});
  State state = resting_state(model);
  loads.add_forces(model, state);
  CHECK(state.nodes.translation.force[0] == Vector{});
  CHECK(state.particles.translation.force[1] == Vector{0.0, 3.0});
  CHECK(state.particles.rotation.moment[1] == 5.0);
  CHECK(state.particles.translation.force[0] == Vector{});

  for (const double time : {2.0, 8.0, 100.0}) {
    state = resting_state(model);
    state.clock.time = time;
    loads.add_forces(model, state);
    CHECK(state.nodes.translation.force[0] == std::min(1.0, time / 8.0) * Vector{4.0, 2.0});
  }
}

TEST_CASE("a load rises within its stage and stays on in later ones") {
  const Model model = bodies();
  AppliedLoads loads({{.body = PointLoad::Body::node, .row = 0, .force = {4.0, 2.0}, .rise_time = 8.0, .stage = 2}});
  State state = resting_state(model);
  state.clock.time = 102.0;
  const auto force_in_stage = [&](std::int64_t stage) {
    state.nodes.translation.force[0] = {};
    state.stage = {.number = stage, .begin_time = 100.0};
    loads.add_forces(model, state);
    return state.nodes.translation.force[0];
  };
  CHECK(force_in_stage(1) == Vector{});
  CHECK(force_in_stage(2) == Vector{1.0, 0.5});
  CHECK(force_in_stage(3) == Vector{4.0, 2.0});
}

TEST_CASE("a load follows its schedule, and its last share stays on in later stages") {
  const Model model = bodies();
  AppliedLoads loads({{.body = PointLoad::Body::node,
                       .row = 0,
                       .force = {4.0, 2.0},
                       .stage = 2,
                       .schedule = {{0.0, 1.0, 2.0, 3.0}, {0.25, 1.0, 1.0, 0.5}}}});
  State state = resting_state(model);
  const auto force_at = [&](std::int64_t stage, double time) {
    state.nodes.translation.force[0] = {};
    state.stage = {.number = stage, .begin_time = 100.0};
    state.clock.time = 100.0 + time;
    loads.add_forces(model, state);
    return state.nodes.translation.force[0];
  };
  CHECK(force_at(1, 1.0) == Vector{});
  CHECK(force_at(2, 0.0) == Vector{1.0, 0.5});
  CHECK(force_at(2, 1.5) == Vector{4.0, 2.0});
  CHECK(force_at(2, 2.5) == Vector{3.0, 1.5});
  CHECK(force_at(2, 9.0) == Vector{2.0, 1.0});
  CHECK(force_at(3, 0.0) == Vector{2.0, 1.0});
}

TEST_CASE("the work of a load is booked by halves on either side of its time") {
  const Model model = bodies();
  AppliedLoads loads({{.body = PointLoad::Body::particle, .row = 1, .force = {0.0, 3.0}, .moment = 5.0}});
  State state = resting_state(model);
  state.clock.time_step = 0.5;
  state.particles.translation.increment[1] = {1.0, 2.0};
  state.particles.rotation.increment[1] = -1.0;
  state.particles.translation.velocity[1] = {1.0, 8.0};
  state.particles.rotation.spin[1] = 2.0;
  loads.book_work(model, state);
  CHECK(state.ledger.total("applied_loads") == 0.5 * (3.0 * 2.0 - 5.0));
  CHECK(state.ledger[state.ledger.open("applied_loads")].pending == 0.5 * (3.0 * 4.0 + 5.0));
  const auto lines = loads.energies(model, state);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].kind == EnergyKind::work);
  CHECK(lines[0].value == 0.5);
}

TEST_CASE("weight follows from the real masses, whatever masses move the bodies") {
  Model model = bodies();
  model.particles.real_mass = {2.0, 3.0};
  model.nodes.real_mass = {5.0};
  Gravity gravity({1.0, -10.0});
  State state = resting_state(model);
  state.particles.translation.mass = {1e6, 1e6};
  gravity.add_forces(model, state);
  CHECK(state.particles.translation.force[0] == Vector{2.0, -20.0});
  CHECK(state.particles.translation.force[1] == Vector{3.0, -30.0});
  CHECK(state.nodes.translation.force[0] == Vector{5.0, -50.0});

  state.particles.translation.displacement = {{0.0, -1.0}, {4.0, 0.0}};
  state.nodes.translation.displacement = {{0.0, 1.0}};
  const auto lines = gravity.energies(model, state);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].kind == EnergyKind::work);
  CHECK(lines[0].value == doctest::Approx(20.0 + 12.0 - 50.0));
}
