#include <doctest/doctest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "integrator/central_difference.hpp"
#include "integrator/dynamic_relaxation.hpp"
#include "integrator/local_damping.hpp"
#include "integrator/no_damping.hpp"
#include "integrator/register_methods.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A disc of unit mass and inertia and a node of unit mass.
Model bodies() {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.5);
  add_node(model, {2.0, 0.0});
  return model;
}

struct FixedDamping : Damping {
  explicit FixedDamping(const DampingCoefficients& fixed) : fixed_coefficients(fixed) {}
  void declare(Parameters& /*parameters*/) override {}
  DampingCoefficients coefficients(const Model& /*model*/, State& /*state*/) override { return fixed_coefficients; }
  DampingCoefficients fixed_coefficients;
};

CentralDifference integrator_with(const DampingCoefficients& damping) {
  return CentralDifference(std::make_unique<FixedDamping>(damping));
}

}  // namespace

TEST_CASE("the steps of leapfrog: velocities from forces, positions from velocities") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = state.clock.time_step_before = 0.5;
  state.particles.translation.force[0] = {2.0, -4.0};
  state.particles.rotation.moment[0] = 6.0;
  state.nodes.translation.force[0] = {8.0, 0.0};
  CentralDifference integrator = integrator_with({});
  for (int n = 1; n <= 2; ++n) {
    integrator.update_velocities(model, state);
    integrator.update_positions(model, state);
  }
  CHECK(state.particles.translation.velocity_before[0] == Vector{1.0, -2.0});
  CHECK(state.particles.translation.velocity[0] == Vector{2.0, -4.0});
  CHECK(state.particles.translation.displacement[0] == Vector{1.5, -3.0});
  CHECK(state.particles.translation.increment[0] == Vector{1.0, -2.0});
  CHECK(state.particles.rotation.spin[0] == 6.0);
  CHECK(state.particles.rotation.rotation[0] == 4.5);
  CHECK(state.nodes.translation.displacement[0] == Vector{6.0, 0.0});
}

TEST_CASE("prescribed freedoms keep their velocity, whatever force and damping") {
  Model model = bodies();
  model.particles.free[0] = {0.0, 1.0};
  model.particles.rotation_free[0] = 0.0;
  State state = resting_state(model);
  state.particles.translation.velocity[0] = {3.0, 0.0};
  state.particles.translation.force[0] = {5.0, 1.0};
  state.particles.rotation.spin[0] = -2.0;
  state.particles.rotation.moment[0] = 9.0;
  integrator_with({.viscous = 0.5, .local = 0.5}).update_velocities(model, state);
  CHECK(state.particles.translation.velocity[0].x == 3.0);
  CHECK(state.particles.translation.velocity[0].y > 0.0);
  CHECK(state.particles.rotation.spin[0] == -2.0);
}

TEST_CASE("viscous damping acts on the mean velocity") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = state.clock.time_step_before = 0.25;
  state.nodes.translation.velocity[0] = {4.0, 0.0};
  state.nodes.translation.force[0] = {1.0, 0.0};
  integrator_with({.viscous = 2.0}).update_velocities(model, state);
  const double after = state.nodes.translation.velocity[0].x;
  CHECK((after - 4.0) / 0.25 == doctest::Approx(1.0 - 2.0 * 0.5 * (4.0 + after)).epsilon(1e-14));
}

TEST_CASE("local damping takes its share of the force against the motion") {
  const Model model = bodies();
  const auto velocity_after = [&](double before, double force) {
    State state = resting_state(model);
    state.particles.translation.velocity[0] = {before, 0.0};
    state.particles.rotation.spin[0] = before;
    state.particles.translation.force[0] = {force, 0.0};
    state.particles.rotation.moment[0] = force;
    integrator_with({.local = 0.5}).update_velocities(model, state);
    CHECK(state.particles.rotation.spin[0] == state.particles.translation.velocity[0].x);
    return state.particles.translation.velocity[0].x;
  };
  CHECK(velocity_after(10.0, 1.0) == 10.5);
  CHECK(velocity_after(10.0, -1.0) == 8.5);
  CHECK(velocity_after(-10.0, -1.0) == -10.5);
  CHECK(velocity_after(0.0, 1.0) == 0.5);
  // Where the motion turns, damping stops its mean at most.
  CHECK(velocity_after(1.0, -2.0) == -1.0);
  CHECK(velocity_after(1.0, 0.0) == 1.0);
}

TEST_CASE("no damping ever gives energy to a body") {
  const Model model = bodies();
  for (const DampingCoefficients damping :
       {DampingCoefficients{.viscous = 1.9}, {.local = 0.9}, {.viscous = 1.0, .local = 0.5}}) {
    for (double before = -3.0; before <= 3.0; before += 0.1) {
      for (double force = -3.0; force <= 3.0; force += 0.1) {
        State state = resting_state(model);
        state.nodes.translation.velocity[0] = {before, 0.0};
        state.nodes.translation.force[0] = {force, 0.0};
        integrator_with(damping).update_velocities(model, state);
        const double after = state.nodes.translation.velocity[0].x;
        const double drag = after - before - force;
        CHECK(drag * (before + after) <= 1e-15);
      }
    }
  }
}

TEST_CASE("dynamic relaxation finds the frequency of an oscillator") {
  const Model model = bodies();
  State state = resting_state(model);
  state.clock.time_step = state.clock.time_step_before = 0.1;
  state.nodes.translation.mass = {4.0};
  DynamicRelaxation damping;
  CHECK(damping.coefficients(model, state).viscous == 0.0);
  // A spring of 9 N/m on 4 kg, moved by 0.1 m: ω = 1.5.
  state.nodes.translation.increment[0] = {0.1, 0.0};
  state.nodes.translation.force[0] = {-0.9, 0.0};
  CHECK(damping.coefficients(model, state).viscous == doctest::Approx(0.9 * 2.0 * 1.5));
  CHECK(state.relaxation.damping == doctest::Approx(0.9 * 2.0 * 1.5));
}

TEST_CASE("where the stiffness along the motion is negative, dynamic relaxation does not damp") {
  const Model model = bodies();
  State state = resting_state(model);
  DynamicRelaxation damping;
  damping.coefficients(model, state);
  state.nodes.translation.increment[0] = {0.1, 0.0};
  state.nodes.translation.force[0] = {0.9, 0.0};
  CHECK(damping.coefficients(model, state).viscous == 0.0);
}

TEST_CASE("dynamic relaxation: prescribed freedoms do not count, and c Δt stays below 2") {
  Model model = bodies();
  model.nodes.free[0] = {0.0, 1.0};
  State state = resting_state(model);
  DynamicRelaxation damping;
  damping.coefficients(model, state);
  state.nodes.translation.increment[0] = {0.1, 0.1};
  state.nodes.translation.force[0] = {-0.9, -0.9};
  CHECK(damping.coefficients(model, state).viscous == 1.9);
  state.nodes.translation.force[0] = {-100.0, -0.9};
  CHECK(damping.coefficients(model, state).viscous == 0.0);
}

TEST_CASE("ways of stepping are found by the name of the solver method, with their parameters") {
  const auto all = solver_methods();
  CHECK(all.names() ==
        std::vector<std::string>{"dynamic_relaxation", "local_damping", "two_level_relaxation", "undamped"});
  CHECK_THROWS_AS(static_cast<void>(all.create("relaxation")), InputError);
  const auto parameter_of = [&](const std::string& method) {
    Parameters parameters;
    const auto integrator = all.create(method);
    integrator->declare(parameters);
    return parameters.empty() ? std::string{} : parameters.list().front().name;
  };
  CHECK(parameter_of("local_damping") == "local_damping");
  CHECK(parameter_of("dynamic_relaxation") == "damping_ratio");
  CHECK(parameter_of("two_level_relaxation") == "smallest_damping");
  CHECK(parameter_of("undamped").empty());
}

TEST_CASE("local damping takes its coefficient from the case") {
  LocalDamping local;
  Parameters parameters;
  local.declare(parameters);
  parameters.list().front().assign(0.25);
  const Model model = bodies();
  State state = resting_state(model);
  CHECK(local.coefficients(model, state).local == 0.25);
  const DampingCoefficients none = NoDamping().coefficients(model, state);
  CHECK(none.local == 0.0);
  CHECK(none.viscous == 0.0);
}
