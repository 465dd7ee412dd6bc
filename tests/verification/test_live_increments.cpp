#include <doctest/doctest.h>

#include <cmath>

#include "integrator/momentum_relaxation.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr double friction = 0.3;
constexpr double press = 10e-6;
constexpr double drag = 100e-6;

using Settings = std::vector<std::pair<std::string, ParameterValue>>;

/// No increment can settle from what contacts remember, and none is cut.
const Settings live_at_once = {
    {"settled_evaluations", std::int64_t{12}}, {"most_evaluations", std::int64_t{10}}, {"smallest_share", 1.0}};

std::unique_ptr<IncrementalLoading> loading(std::vector<PrescribedFreedom> freedoms, const Settings& settings) {
  auto result = std::make_unique<IncrementalLoading>(std::make_unique<MomentumRelaxation>());
  Parameters parameters;
  result->declare(parameters);
  for (Parameter& parameter : parameters.list()) {
    if (parameter.name == "increment") parameter.assign(2e-6);
    for (const auto& [name, value] : settings) {
      if (parameter.name == name) parameter.assign(value);
    }
  }
  result->set_loading(std::move(freedoms), {{1.0}, {1.0}}, 1e-6);
  return result;
}

/// A disc that cannot turn, between a floor with friction, a smooth ceiling and a smooth stop on its right. In the
/// first stage the ceiling presses it down, in the second the floor drags it against the stop, until it slides.
struct DraggedBlock {
  Simulation simulation;

  explicit DraggedBlock(const Settings& settings, double skin = 1e-3) : simulation(make(settings, skin)) {
    simulation.open_stages(2, 0);
  }

  static Simulation make(const Settings& settings, double skin) {
    Model model = empty_model();
    add_particle(model, {0.0, radius}, radius);
    const std::size_t floor = add_wall(model, {1.0, 0.0}, {-1.0, 0.0}, {.friction_coefficient = friction});
    const std::size_t ceiling = add_wall(model, {-1.0, 2.0 * radius}, {1.0, 2.0 * radius});
    const std::size_t stop = add_wall(model, {radius, 1.0}, {radius, -1.0});
    std::vector<PrescribedFreedom> freedoms = {held_particle(0)[2]};
    const auto hold = [&](std::size_t wall, int axis, const std::vector<StageVelocity>& motions) {
      for (const Index node : model.wall_nodes(wall)) {
        for (PrescribedFreedom freedom : held_node(node)) {
          if (freedom.axis == axis) freedom.motions = motions;
          freedoms.push_back(freedom);
        }
      }
    };
    hold(floor, 0, {{.stage = 2, .velocity = drag, .stop_time = 1.0}});
    hold(ceiling, 1, {{.stage = 1, .velocity = -press, .stop_time = 1.0}});
    hold(stop, 0, {});
    auto constraint = std::make_unique<PrescribedMotion>(freedoms);
    constraint->fix(model);
    Modules modules;
    modules.loading = loading(freedoms, settings);
    modules.contact_detector = std::make_unique<GridContactDetector>(skin);
    modules.force_providers.push_back(std::make_unique<ContactForces<FacetPairing>>());
    modules.constraints.push_back(std::move(constraint));
    return {std::move(model), std::move(modules), {.masses = Masses::scaled}};
  }

  void press_and_drag() {
    for (int stage = 1; stage <= 2; ++stage) {
      while (simulation.state().clock.time < stage - 1e-9) {
        REQUIRE(simulation.advance());
        simulation.audit();
      }
      if (stage == 1) simulation.finish_stage({});
    }
  }
  [[nodiscard]] const ContactTable& contacts() const { return simulation.state().facet_contacts; }
};

}  // namespace

TEST_CASE("a block dragged past sliding in live increments spends its friction times its slip") {
  for (const double skin : {1e-3, 4e-6}) {
    DraggedBlock block(live_at_once, skin);
    const double k_n = block.contacts().normal_stiffness[0];
    const double k_s = block.contacts().shear_stiffness[0];
    block.press_and_drag();
    const double pressure = 0.5 * k_n * press;
    const double limit = friction * pressure;
    // Floor, ceiling, stop: the order of their facets.
    CHECK(block.contacts().normal_force[0] == doctest::Approx(pressure).epsilon(1e-4));
    CHECK(std::abs(block.contacts().shear_force[0]) == doctest::Approx(limit).epsilon(1e-4));
    CHECK(block.contacts().normal_force[2] == doctest::Approx(limit).epsilon(1e-4));
    const double slip = drag - limit / k_s - limit / k_n;
    CHECK(energy(block.simulation, "friction") == doctest::Approx(limit * slip).epsilon(1e-3));
    CHECK(block.simulation.state().ledger.largest_error < 1e-6);
    // A search with so thin a skin goes on while an increment is under way.
    CHECK((block.simulation.state().search.n_updates > 0) == (skin < 1e-3));
  }
}

TEST_CASE("friction is the same whether contacts remember the last equilibrium or live") {
  DraggedBlock frozen({});
  DraggedBlock live(live_at_once);
  frozen.press_and_drag();
  live.press_and_drag();
  CHECK(energy(live.simulation, "friction") == doctest::Approx(energy(frozen.simulation, "friction")).epsilon(1e-3));
  CHECK(energy(live.simulation, "prescribed_motions") ==
        doctest::Approx(energy(frozen.simulation, "prescribed_motions")).epsilon(1e-3));
  CHECK(std::abs(energy(live.simulation, "released")) < 1e-2 * energy(live.simulation, "prescribed_motions"));
}

TEST_CASE("a live increment without equilibrium within its limits leaves the last one as it was") {
  Settings settings = live_at_once;
  settings.emplace_back("most_live_evaluations", std::int64_t{50});
  DraggedBlock block(settings, 1e-6);
  const State before = block.simulation.state();
  CHECK_FALSE(block.simulation.advance());
  const State& after = block.simulation.state();
  CHECK(after.clock.time == before.clock.time);
  CHECK(after.facet_contacts.opening == before.facet_contacts.opening);
  CHECK(after.search.n_updates == before.search.n_updates);
  CHECK(after.particles.translation.displacement == before.particles.translation.displacement);
  CHECK(after.ledger.total("released") == 0.0);
}
