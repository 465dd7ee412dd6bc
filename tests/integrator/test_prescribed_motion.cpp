#include <doctest/doctest.h>

#include "integrator/prescribed_motion.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

using Body = PrescribedFreedom::Body;

Model bodies() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  add_node(model, {2.0, 0.0});
  return model;
}

/// The velocity given to the node at a time.
double velocity_at(const PrescribedFreedom& freedom, double time, double time_step) {
  Model model = bodies();
  State state = resting_state(model);
  state.clock.time = time;
  state.clock.time_step = time_step;
  PrescribedMotion({freedom}).apply(model, state);
  return state.nodes.translation.velocity[0].x;
}

}  // namespace

TEST_CASE("prescribed freedoms are taken from the integrator, the others are not") {
  Model model = bodies();
  PrescribedMotion({{.body = Body::node, .row = 0, .axis = 1},
                    {.body = Body::particle, .row = 0, .axis = 0},
                    {.body = Body::particle, .row = 0, .axis = dimension}})
      .fix(model);
  CHECK(model.nodes.free[0] == Vector{1.0, 0.0});
  CHECK(model.particles.free[0] == Vector{0.0, 1.0});
  CHECK(model.particles.rotation_free[0] == 0.0);
}

TEST_CASE("velocities rise, hold and stop and they are those of the middle of the step") {
  const PrescribedFreedom freedom{
      .body = Body::node, .row = 0, .axis = 0, .motions = {{.velocity = 3.0, .rise_time = 2.0, .stop_time = 5.0}}};
  CHECK(velocity_at(freedom, 0.0, 0.5) == 3.0 * 0.125);
  CHECK(velocity_at(freedom, 0.75, 0.5) == 1.5);
  CHECK(velocity_at(freedom, 1.75, 0.5) == 3.0);
  CHECK(velocity_at(freedom, 4.5, 0.5) == 3.0);
  CHECK(velocity_at(freedom, 4.75, 0.5) == 0.0);
  CHECK(velocity_at(freedom, 9.0, 0.5) == 0.0);
  const PrescribedFreedom endless{.body = Body::node, .row = 0, .axis = 0, .motions = {{.velocity = 3.0}}};
  CHECK(velocity_at(endless, 0.0, 0.5) == 3.0);
  CHECK(velocity_at(endless, 1e9, 0.5) == 3.0);
}

TEST_CASE("on a schedule every step ends where the schedule says, also across corners") {
  const PiecewiseLinear schedule{{0.0, 1.0, 1.5, 4.0}, {0.0, 0.3, 0.3, -0.2}};
  const PrescribedFreedom freedom{.body = Body::node, .row = 0, .axis = 0, .motions = {{.schedule = schedule}}};
  CHECK(velocity_at(freedom, 0.25, 0.5) == 0.3);
  CHECK(velocity_at(freedom, 1.0, 0.5) == 0.0);
  CHECK(velocity_at(freedom, 2.0, 0.5) == -0.5 / 2.5);
  CHECK(velocity_at(freedom, 4.0, 0.5) == 0.0);
  double displacement = 0.0;
  for (double time = 0.0; time < 5.0; time += 0.7) {
    displacement += 0.7 * velocity_at(freedom, time, 0.7);
    CHECK(displacement == doctest::Approx(schedule.value(time + 0.7)).epsilon(1e-13));
  }
}

TEST_CASE("velocities belong to stages, and count their time from the beginning of theirs") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = 0.5;
  PrescribedMotion motion({{.body = Body::node,
                            .row = 0,
                            .axis = 0,
                            .motions = {{.stage = 1, .velocity = 3.0, .stop_time = 5.0},
                                        {.stage = 3, .velocity = -2.0, .rise_time = 4.0}}}});
  const auto velocity_in = [&](std::int64_t stage, double begin_time, double time) {
    state.stage = {.number = stage, .begin_time = begin_time};
    state.clock.time = time;
    motion.apply(model, state);
    return state.nodes.translation.velocity[0].x;
  };
  CHECK(velocity_in(1, 0.0, 4.5) == 3.0);
  CHECK(velocity_in(1, 0.0, 5.0) == 0.0);
  CHECK(velocity_in(2, 10.0, 11.0) == 0.0);
  CHECK(velocity_in(3, 20.0, 20.75) == -0.5);
  CHECK(velocity_in(3, 20.0, 30.0) == -2.0);
}

TEST_CASE("all kinds of freedom are moved") {
  Model model = bodies();
  State state = resting_state(model);
  PrescribedMotion({{.body = Body::node, .row = 0, .axis = 1, .motions = {{.velocity = 1.0}}},
                    {.body = Body::particle, .row = 0, .axis = 0, .motions = {{.velocity = 2.0}}},
                    {.body = Body::particle, .row = 0, .axis = dimension, .motions = {{.velocity = 3.0}}}})
      .apply(model, state);
  CHECK(state.nodes.translation.velocity[0] == Vector{0.0, 1.0});
  CHECK(state.particles.translation.velocity[0] == Vector{2.0, 0.0});
  CHECK(state.particles.rotation.spin[0] == 3.0);
}

TEST_CASE("the reaction is what the motion shows beyond the resultant, and works on both sides of its time") {
  Model model = bodies();
  PrescribedMotion motion({{.body = Body::node, .row = 0, .axis = 0, .motions = {{.velocity = 3.0}}}});
  motion.fix(model);
  State state = resting_state(model);
  state.clock.time_step = state.clock.time_step_before = 0.5;
  state.nodes.translation.mass[0] = 2.0;
  state.nodes.translation.velocity_before[0] = {1.0, 0.0};
  state.nodes.translation.increment[0] = {0.5, 0.0};
  state.nodes.translation.force[0] = {-7.0, 4.0};
  motion.apply(model, state);
  // 2 · (3 - 1) / 0.5 + 7 = 15; the free axis has none.
  CHECK(reaction(state.nodes.translation, model.nodes.free, state.clock, 0) == Vector{15.0, 0.0});
  motion.book_work(model, state);
  CHECK(state.ledger.total("prescribed_motions") == 0.5 * 15.0 * 0.5);
  CHECK(state.ledger[state.ledger.open("prescribed_motions")].pending == 0.5 * 15.0 * 3.0 * 0.5);
}
