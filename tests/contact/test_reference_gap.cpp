#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "support/three_kinds_of_contact.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double skin = 1e-3;

/// Cuts all bonds: they go on as contacts without cohesion, under the law of their own.
void cut(Model& model, State& state) {
  model.laws[bond_law].law = model.laws[contact_law].law->contact_law();
  model.laws[bond_law].n_history = 1;
  for (ContactTable* contacts : {&state.particle_contacts, &state.facet_contacts, &state.corner_contacts}) {
    std::fill(contacts->bond.begin(), contacts->bond.end(), BondState::broken);
    const auto n_cut = static_cast<std::size_t>(contacts->law_begin[1]);
    contacts->history = make_history(model);
    contacts->history[0].values.assign(n_cut, 0.0);
    contacts->history[1].values.assign(contacts->size() - n_cut, 0.0);
  }
}

double largest_force(const State& state) {
  double largest = 0.0;
  for (const Vector& force : state.particles.translation.force) largest = std::max(largest, norm(force));
  for (const Vector& force : state.nodes.translation.force) largest = std::max(largest, norm(force));
  return largest;
}

/// Moves the first disc along a direction, the solid and the others staying.
void move_first(ThreeKindsOfContact& bodies, GridContactDetector& detector, const Vector& displacement) {
  displace(bodies.state.particles.translation, 0, displacement);
  detector.update(bodies.model, bodies.state);
  bodies.add_forces();
  // Positions of this step are those before the next one.
  displace(bodies.state.particles.translation, 0, displacement);
}

/// One disc and one facet, `distance` apart, the facet from (0, 0) to (1, 0) with its solid below.
struct DiscAboveFacet {
  Model model = empty_model();
  State state;
  GridContactDetector detector{skin};

  explicit DiscAboveFacet(double distance, double radius = 0.1, double place = 0.5) {
    add_node(model, {1.0, 0.0});
    add_node(model, {0.0, 0.0});
    add_facet(model, 0, 1);
    add_particle(model, {place, distance}, radius);
    state = resting_state(model);
    detector.bond(model, state);
  }
  Vector force_at(const Vector& displacement) {
    displace(state.particles.translation, 0, displacement);
    detector.update(model, state);
    clear_forces(state);
    ContactForces<FacetPairing>().add_forces(model, state);
    ContactForces<CornerPairing>().add_forces(model, state);
    return state.particles.translation.force[0];
  }
};

}  // namespace

TEST_CASE("pairs that overlap by a tenth at set-up feel nothing, bonded or cut") {
  ThreeKindsOfContact bodies;
  bodies.add_forces();
  CHECK(largest_force(bodies.state) == 0.0);
  cut(bodies.model, bodies.state);
  bodies.add_forces();
  CHECK(largest_force(bodies.state) == 0.0);
}

TEST_CASE(
    "a cut pair feels nothing when it opens, the spring when it closes, nothing again at its distance of set-up") {
  ThreeKindsOfContact bodies;
  GridContactDetector detector(skin);
  detector.bond(bodies.model, bodies.state);
  cut(bodies.model, bodies.state);
  const Vector outwards{1.0, 0.0};
  const double k_facet = bodies.state.facet_contacts.normal_stiffness[0];
  move_first(bodies, detector, 2e-4 * outwards);
  CHECK(bodies.state.facet_contacts.normal_force[0] == 0.0);
  move_first(bodies, detector, -2e-4 * outwards);
  CHECK(bodies.state.facet_contacts.normal_force[0] == doctest::Approx(2e-4 * k_facet).epsilon(1e-12));
  move_first(bodies, detector, {});
  CHECK(bodies.state.facet_contacts.normal_force[0] < 1e-12 * k_facet);
}

TEST_CASE("cut pairs that leave the list and are found again have kept their distance of set-up") {
  ThreeKindsOfContact bodies;
  GridContactDetector detector(skin);
  detector.bond(bodies.model, bodies.state);
  cut(bodies.model, bodies.state);
  const double k_particles = bodies.state.particle_contacts.normal_stiffness[0];
  const double k_facet = bodies.state.facet_contacts.normal_stiffness[0];
  const double k_corner = bodies.state.corner_contacts.normal_stiffness[0];
  // Everything apart, then back.
  const std::array<Vector, 3> away{Vector{0.05, -0.1}, {0.3, 0.3}, {0.2, 0.2}};
  for (std::size_t i = 0; i < 3; ++i) displace(bodies.state.particles.translation, i, away[i]);
  REQUIRE(detector.update(bodies.model, bodies.state));
  for (const ContactTable* contacts : bodies.tables()) REQUIRE(contacts->size() == 0);
  for (std::size_t i = 0; i < 3; ++i) displace(bodies.state.particles.translation, i, {});
  REQUIRE(detector.update(bodies.model, bodies.state));
  for (const ContactTable* contacts : bodies.tables()) {
    REQUIRE(contacts->size() == 1);
    CHECK(contacts->bond[0] == BondState::unbonded);
    CHECK(contacts->law[0] == contact_law);
  }
  bodies.add_forces();
  CHECK(largest_force(bodies.state) < 1e-12 * k_facet);
  displace(bodies.state.particles.translation, 0, {-1e-5, 0.0});
  displace(bodies.state.particles.translation, 2, {-1e-5, 0.0});
  bodies.add_forces();
  CHECK(bodies.state.facet_contacts.normal_force[0] ==
        doctest::Approx(1e-5 * bodies.state.facet_contacts.normal_stiffness[0]).epsilon(1e-8));
  CHECK(bodies.state.corner_contacts.normal_force[0] > 0.0);
  // Springs are those of set-up: they follow from the same distance.
  CHECK(bodies.state.particle_contacts.normal_stiffness[0] == doctest::Approx(k_particles).epsilon(1e-14));
  CHECK(bodies.state.facet_contacts.normal_stiffness[0] == doctest::Approx(k_facet).epsilon(1e-14));
  CHECK(bodies.state.corner_contacts.normal_stiffness[0] == doctest::Approx(k_corner).epsilon(1e-14));
}

TEST_CASE("pairs apart at set-up touch when their surfaces do") {
  Model model = empty_model();
  add_particle(model, {0.0, 0.0}, 0.1);
  add_particle(model, {0.25, 0.0}, 0.1);
  State state = resting_state(model);
  GridContactDetector detector(skin);
  detector.bond(model, state);
  CHECK(state.particle_contacts.size() == 0);
  displace(state.particles.translation, 1, {-0.0495, 0.0});
  REQUIRE(detector.update(model, state));
  REQUIRE(state.particle_contacts.size() == 1);
  CHECK(state.particle_contacts.opening[0] == doctest::Approx(5e-4).epsilon(1e-10));
  displace(state.particles.translation, 1, {-0.0501, 0.0});
  ContactForces<ParticlePairing>().add_forces(model, state);
  // Eq. (33) with L = r_A + r_B.
  CHECK(state.particles.translation.force[1].x == doctest::Approx(1e-4 * 1e9 / 0.96).epsilon(1e-8));
}

TEST_CASE("a disc bonded across a gap, cut, comes back to find the facet at that gap") {
  // 1.4 R: within the detection gap of half a radius.
  DiscAboveFacet bodies(0.14);
  REQUIRE(bodies.state.facet_contacts.size() == 1);
  CHECK(bodies.state.facet_contacts.bond[0] == BondState::bonded);
  cut(bodies.model, bodies.state);
  CHECK(bodies.force_at({0.0, 0.0006}).y == 0.0);
  CHECK(bodies.state.facet_contacts.size() == 1);
  CHECK(bodies.force_at({0.0, 0.01}).y == 0.0);
  CHECK(bodies.state.facet_contacts.size() == 0);
  CHECK(std::abs(bodies.force_at({0.0, 0.0}).y) < 1e-6);
  REQUIRE(bodies.state.facet_contacts.size() == 1);
  const double k_n = bodies.state.facet_contacts.normal_stiffness[0];
  CHECK(bodies.force_at({0.0, -1e-4}).y == doctest::Approx(1e-4 * k_n).epsilon(1e-9));
}

namespace {

/// A disc above a solid with two facets in line, from (0, 0) to (1, 0) to (2, 0), and a convex corner at (2, 0).
struct DiscAboveSolid {
  Model model = empty_model();
  State state;
  GridContactDetector detector{skin};

  explicit DiscAboveSolid(const Vector& place) {
    add_outline(model, {{0.0, -1.0}, {2.0, -1.0}, {2.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}});
    add_particle(model, place, 0.1);
    state = resting_state(model);
    detector.bond(model, state);
  }
  void move(const Vector& displacement) {
    displace(state.particles.translation, 0, displacement);
    detector.update(model, state);
    clear_forces(state);
    ContactForces<FacetPairing>().add_forces(model, state);
    ContactForces<CornerPairing>().add_forces(model, state);
  }
  [[nodiscard]] std::size_t n_contacts() const { return state.facet_contacts.size() + state.corner_contacts.size(); }
};

}  // namespace

TEST_CASE("a bond never changes its facet: past the end of it there is no second contact") {
  SUBCASE("to the facet in line") {
    DiscAboveSolid bodies({0.99, 0.05});
    bodies.move({0.03, 0.0});
    CHECK(bodies.n_contacts() == 1);
    CHECK(bodies.state.facet_contacts.second[0] == 3);
    CHECK(std::abs(bodies.state.facet_contacts.normal_force[0]) < 1e-6);
  }
  SUBCASE("around a convex corner") {
    DiscAboveSolid bodies({1.98, 0.05});
    bodies.move({0.05, 0.0});
    CHECK(bodies.n_contacts() == 1);
    CHECK(bodies.state.facet_contacts.second[0] == 2);
  }
  SUBCASE("from a corner to a facet") {
    DiscAboveSolid bodies({2.05, 0.05});
    REQUIRE(bodies.state.corner_contacts.size() == 1);
    bodies.move({-0.1, 0.0});
    CHECK(bodies.n_contacts() == 1);
    CHECK(bodies.state.corner_contacts.size() == 1);
  }
}

TEST_CASE("a cut disc that slides past the end of its facet takes its distance of reference along") {
  SUBCASE("to the facet in line") {
    DiscAboveSolid bodies({0.99, 0.05});
    cut(bodies.model, bodies.state);
    for (int step = 1; step <= 30; ++step) bodies.move({0.001 * step, 0.0});
    REQUIRE(bodies.n_contacts() == 1);
    CHECK(bodies.state.facet_contacts.second[0] == 2);
    CHECK(std::abs(bodies.state.facet_contacts.opening[0]) < 1e-15);
    CHECK(bodies.state.facet_contacts.normal_force[0] < 1e-5);
  }
  SUBCASE("around a convex corner") {
    DiscAboveSolid bodies({1.99, 0.05});
    cut(bodies.model, bodies.state);
    // Along the facet, then around the corner at the same distance.
    for (int step = 1; step <= 10; ++step) bodies.move({0.001 * step, 0.0});
    for (int step = 1; step <= 20; ++step) {
      const double angle = 0.02 * step;
      bodies.move({0.01 + 0.05 * std::sin(angle), 0.05 * (std::cos(angle) - 1.0)});
    }
    REQUIRE(bodies.n_contacts() == 1);
    REQUIRE(bodies.state.corner_contacts.size() == 1);
    CHECK(std::abs(bodies.state.corner_contacts.opening[0]) < 1e-15);
  }
  SUBCASE("bonded across a gap") {
    DiscAboveSolid bodies({0.99, 0.14});
    cut(bodies.model, bodies.state);
    for (int step = 1; step <= 30; ++step) bodies.move({0.001 * step, -1e-4});
    REQUIRE(bodies.n_contacts() == 1);
    CHECK(bodies.state.facet_contacts.second[0] == 2);
    CHECK(bodies.state.facet_contacts.opening[0] == doctest::Approx(-1e-4).epsilon(1e-10));
  }
}

TEST_CASE("a disc whose centre lies on a facet or a node is refused at set-up") {
  CHECK_THROWS_WITH_AS(DiscAboveFacet(0.0), doctest::Contains("particle 1"), InputError);
  CHECK_THROWS_AS(DiscAboveFacet(1e-9), InputError);
  CHECK_THROWS_AS(DiscAboveFacet(-0.05), InputError);
  CHECK_NOTHROW(DiscAboveFacet(0.01));
}

TEST_CASE("the length of an interface contact is a quarter of the radius at least") {
  const auto stiffness = [](double distance) {
    return DiscAboveFacet(distance).state.facet_contacts.normal_stiffness[0];
  };
  CHECK(stiffness(0.05) == doctest::Approx(1e9 / 0.96 * 0.2 / 0.05).epsilon(1e-12));
  CHECK(stiffness(0.14) == doctest::Approx(1e9 / 0.96 * 0.2 / 0.14).epsilon(1e-12));
  CHECK(stiffness(0.01) == doctest::Approx(1e9 / 0.96 * 0.2 / 0.025).epsilon(1e-12));
}
