#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "support/energy_drift.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/moved_bodies.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr double friction = 0.3;
constexpr double skin = 1e-3;

/// A solid with two facets in line on top, from (0, 0) to (1, 0) to (2, 0), and a convex corner at (2, 0).
Model solid() {
  Model model = empty_model({.friction_coefficient = friction, .interface_gap = 0.0});
  add_outline(model, {{0.0, -1.0}, {2.0, -1.0}, {2.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}});
  return model;
}

/// A disc led along a path against the solid, without turning; sums the work done on it.
class LedDisc {
 public:
  LedDisc(Vector rest, const std::function<Vector(double)>& path) : path_(path), model_(solid()) {
    add_particle(model_, rest, radius);
    state_ = resting_state(model_);
    detector_.bond(model_, state_);
    move_to(path_(0.0));
  }

  /// From s to s + ds along the path (m).
  void lead(double s) {
    const Vector force_before = state_.particles.translation.force[0];
    move_to(path_(s));
    work_ -= 0.5 * dot(force_before + state_.particles.translation.force[0], state_.particles.translation.increment[0]);
  }
  [[nodiscard]] double shear_force() const {
    double sum = 0.0;
    for (const ContactTable* contacts : {&state_.facet_contacts, &state_.corner_contacts}) {
      for (const ShearVector shear : contacts->shear_force) sum += shear;
    }
    return sum;
  }
  [[nodiscard]] std::size_t n_contacts() const { return state_.facet_contacts.size() + state_.corner_contacts.size(); }
  [[nodiscard]] double work() const { return work_; }
  [[nodiscard]] double booked(EnergyKind kind, const std::string& name = "") const {
    double sum = 0.0;
    const auto add = [&](const std::vector<EnergyTerm>& terms) {
      for (const EnergyTerm& term : terms) {
        if (term.kind == kind && (name.empty() || term.name == name)) sum += term.value;
      }
    };
    add(facets_.energies(model_, state_));
    add(corners_.energies(model_, state_));
    add(detector_.energies(model_, state_));
    return sum;
  }
  [[nodiscard]] double normal_stiffness() const { return state_.facet_contacts.normal_stiffness[0]; }

 private:
  void move_to(const Vector& place) {
    displace(state_.particles.translation, 0, place - model_.particles.position[0]);
    detector_.update(model_, state_);
    clear_forces(state_);
    facets_.add_forces(model_, state_);
    corners_.add_forces(model_, state_);
  }

  std::function<Vector(double)> path_;
  Model model_;
  State state_;
  GridContactDetector detector_{skin};
  ContactForces<FacetPairing> facets_;
  ContactForces<CornerPairing> corners_;
  double work_ = 0.0;
};

}  // namespace

TEST_CASE("a disc that slides over the common node of two facets in line keeps its shear force and friction work") {
  constexpr double overlap = 1e-5;
  LedDisc disc({0.9, radius + 1e-9}, [](double s) { return Vector{0.9 + s, radius - overlap}; });
  const double limit = friction * overlap * disc.normal_stiffness();
  const double start_energy = disc.booked(EnergyKind::elastic);
  double largest_jump = 0.0;
  double highest = 0.0;
  double before = disc.shear_force();
  for (int step = 1; step <= 2000; ++step) {
    disc.lead(1e-4 * step);
    REQUIRE(disc.n_contacts() == 1);
    if (step > 10) largest_jump = std::max(largest_jump, std::abs(disc.shear_force() - before));
    before = disc.shear_force();
    REQUIRE(disc.booked(EnergyKind::dissipated, "friction") >= highest);
    highest = disc.booked(EnergyKind::dissipated, "friction");
  }
  CHECK(std::abs(before) == doctest::Approx(limit).epsilon(1e-9));
  CHECK(largest_jump < 1e-9 * limit);
  const double stored = disc.booked(EnergyKind::elastic) - start_energy;
  CHECK(highest + stored + disc.booked(EnergyKind::dissipated, "contacts_lost") ==
        doctest::Approx(disc.work()).epsilon(1e-10));
  CHECK(std::abs(disc.booked(EnergyKind::dissipated, "contacts_lost")) < 1e-12 * disc.work());
  CHECK(disc.work() == doctest::Approx(limit * 0.2).epsilon(1e-3));
}

TEST_CASE("a disc that slides around a convex corner keeps its shear force and friction work") {
  constexpr double overlap = 1e-4;
  constexpr double distance = radius - overlap;
  const double arc = 0.5 * std::numbers::pi * distance;
  // 0.1 m along the top, a quarter of a circle, 0.1 m down the side.
  const auto path = [&](double s) {
    if (s < 0.1) return Vector{1.9 + s, distance};
    if (s > 0.1 + arc) return Vector{2.0 + distance, -(s - 0.1 - arc)};
    const double angle = (s - 0.1) / distance;
    return Vector{2.0 + distance * std::sin(angle), distance * std::cos(angle)};
  };
  LedDisc disc({1.9, radius + 1e-9}, path);
  const double limit = friction * overlap * disc.normal_stiffness();
  const double start_energy = disc.booked(EnergyKind::elastic);
  double largest_change = 0.0;
  double highest = 0.0;
  const double length = 0.2 + arc;
  constexpr int n_steps = 20000;
  for (int step = 1; step <= n_steps; ++step) {
    disc.lead(length * step / n_steps);
    REQUIRE(disc.n_contacts() >= 1);
    if (step > n_steps / 100) largest_change = std::max(largest_change, std::abs(std::abs(disc.shear_force()) - limit));
    REQUIRE(disc.booked(EnergyKind::dissipated, "friction") >= highest);
    highest = disc.booked(EnergyKind::dissipated, "friction");
  }
  // Within half a skin past an end the list still holds the old neighbour, whose distance differs in second order.
  CHECK(largest_change < 0.1 * limit);
  CHECK(std::abs(disc.shear_force()) == doctest::Approx(limit).epsilon(1e-9));
  CHECK(disc.work() == doctest::Approx(limit * length).epsilon(2e-3));
  const double stored = disc.booked(EnergyKind::elastic) - start_energy;
  const double lost = disc.booked(EnergyKind::dissipated, "contacts_lost");
  CHECK(std::abs(lost) < 1e-5 * disc.work());
  CHECK(highest + stored + lost == doctest::Approx(disc.work()).epsilon(1e-6));
}

TEST_CASE("a block that slides freely over the common node of two facets closes its ledger") {
  Model model = solid();
  for (Index node = 0; node < 5; ++node) model.nodes.real_mass[node] = 1e3;
  SimulationChoice choice;
  choice.skin = skin;
  choice.gravity = Vector{0.0, -9.81};
  for (Index node = 0; node < 5; ++node) {
    for (const PrescribedFreedom& freedom : held_node(node)) choice.prescribed.push_back(freedom);
  }
  add_particle(model, {0.95, radius + 1e-9}, radius);
  Simulation simulation = make_simulation(std::move(model), std::move(choice));
  set_velocity(simulation, 0, {1.0, 0.0});
  EnergyDrift drift(simulation);
  while (simulation.state().particles.translation.displacement[0].x < 0.1) {
    simulation.step();
    drift.measure(simulation);
  }
  CHECK(simulation.state().facet_contacts.second[0] == 2);
  // The first touch falls inside a step, whose trapezoid knows nothing of the kink.
  CHECK(drift.largest() < 1e-8);
  CHECK(energy(simulation, "friction") > 0.0);
}
