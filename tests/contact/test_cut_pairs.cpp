#include <doctest/doctest.h>

#include <algorithm>

#include "contact/cut_pairs.hpp"
#include "support/random_numbers.hpp"
#include "support/three_kinds_of_contact.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double skin = 1e-3;

/// Two discs of radius 0.1 with 10 % overlap along x, and a notch between them.
struct CutPair {
  Model model = empty_model();
  State state;
  GridContactDetector detector{skin};

  CutPair() {
    add_particle(model, {0.0, 0.0}, 0.1);
    add_particle(model, {0.18, 0.0}, 0.1);
    model.notches.push_back({.name = "notch", .from = {0.09, -1.0}, .to = {0.09, 1.0}});
    state = resting_state(model);
    detector.bond(model, state);
  }
  /// Moves the second disc by an increment, and finds the forces.
  void move(const Vector& increment) {
    TranslationState& translation = state.particles.translation;
    displace(translation, 1, translation.displacement[1] + increment);
    detector.update(model, state);
    clear_forces(state);
    ContactForces<ParticlePairing>().add_forces(model, state);
    translation.increment[1] = {};
  }
  [[nodiscard]] const ContactTable& contacts() const { return state.particle_contacts; }
};

/// Whether two segments cross, by the parameters of the crossing point on both.
bool segments_cross(const Vector& a, const Vector& b, const Vector& p, const Vector& q) {
  const double determinant = cross(b - a, q - p);
  const double on_first = cross(p - a, q - p) / determinant;
  const double on_second = cross(p - a, b - a) / determinant;
  return on_first >= 0.0 && on_first <= 1.0 && on_second >= 0.0 && on_second <= 1.0;
}

}  // namespace

TEST_CASE("a cut pair has no bond and feels nothing at its distance of set-up") {
  CutPair bodies;
  REQUIRE(bodies.contacts().size() == 1);
  CHECK(bodies.contacts().bond[0] == BondState::unbonded);
  CHECK(bodies.contacts().law[0] == contact_law);
  CHECK(bodies.model.particle_pairs.size() == 1);
  CHECK(bodies.model.cut_particle_pairs == bodies.model.particle_pairs);
  bodies.move({});
  CHECK(bodies.contacts().normal_force[0] == 0.0);
  CHECK(norm(bodies.state.particles.translation.force[1]) == 0.0);
}

TEST_CASE("a cut pair presses when it closes, holds no tension, and rubs") {
  CutPair bodies;
  // Eq. (33) with the distance at set-up.
  const double k_n = 1e9 / 0.96 * 0.2 / 0.18;
  bodies.move({-1e-5, 0.0});
  CHECK(bodies.contacts().normal_force[0] == doctest::Approx(1e-5 * k_n).epsilon(1e-10));
  bodies.move({0.0, 1e-4});
  CHECK(std::abs(bodies.contacts().shear_force[0]) ==
        doctest::Approx(0.3 * bodies.contacts().normal_force[0]).epsilon(1e-12));
  bodies.move({2e-5, 0.0});
  CHECK(bodies.contacts().normal_force[0] == 0.0);
  CHECK(bodies.contacts().shear_force[0] == 0.0);
  CHECK(norm(bodies.state.particles.translation.force[1]) == 0.0);
}

TEST_CASE("a cut pair that is lost and found again has kept its distance, and has no bond") {
  CutPair bodies;
  bodies.move({0.1, 0.0});
  REQUIRE(bodies.contacts().size() == 0);
  bodies.move({-0.1, 0.0});
  REQUIRE(bodies.contacts().size() == 1);
  CHECK(bodies.contacts().bond[0] == BondState::unbonded);
  const double k_n = bodies.contacts().normal_stiffness[0];
  CHECK(k_n == doctest::Approx(1e9 / 0.96 * 0.2 / 0.18).epsilon(1e-12));
  CHECK(std::abs(bodies.contacts().normal_force[0]) < 1e-12 * k_n);
  bodies.move({-1e-5, 0.0});
  CHECK(bodies.contacts().normal_force[0] == doctest::Approx(1e-5 * k_n).epsilon(1e-8));
}

TEST_CASE("a notch that ends before the branch, or lies beside it, cuts nothing") {
  Notch notch{.name = "notch", .from = {0.5, 0.0}, .to = {0.5, 1.0}};
  CHECK(separates(notch, {0.0, 0.5}, {1.0, 0.5}));
  CHECK(separates(notch, {1.0, 0.5}, {0.0, 0.5}));
  CHECK(separates(notch, {0.0, 1.0}, {1.0, 1.0}));  // touches the tip
  CHECK_FALSE(separates(notch, {0.0, 1.001}, {1.0, 1.001}));
  CHECK_FALSE(separates(notch, {0.0, 0.5}, {0.4, 0.5}));
  CHECK_FALSE(separates(notch, {0.6, 0.5}, {0.9, 0.5}));
}

TEST_CASE("the pairs that are cut are those whose branches cross the notch") {
  Model model = empty_model({.detection_gap = 0.5});
  RandomNumbers random(3);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(0.0, 1.0);
    add_particle(model, {x, random.uniform(0.0, 1.0)}, 0.03);
  }
  model.notches.push_back({.name = "first", .from = {0.1, 0.05}, .to = {0.8, 0.7}});
  model.notches.push_back({.name = "second", .from = {0.9, 0.1}, .to = {0.3, 0.9}});
  State state = resting_state(model);
  GridContactDetector(skin).bond(model, state);
  std::vector<SetupPair> expected;
  for (const SetupPair& pair : model.particle_pairs) {
    const Vector& a = model.particles.position[pair.first];
    const Vector& b = model.particles.position[pair.second];
    const bool is_cut = std::any_of(model.notches.begin(), model.notches.end(),
                                    [&](const Notch& notch) { return segments_cross(a, b, notch.from, notch.to); });
    if (is_cut) expected.push_back(pair);
  }
  REQUIRE(expected.size() > 20);
  CHECK(model.cut_particle_pairs == expected);
  const auto& bonds = state.particle_contacts.bond;
  const auto n_bonded = static_cast<std::size_t>(std::count(bonds.begin(), bonds.end(), BondState::bonded));
  CHECK(n_bonded == model.particle_pairs.size() - expected.size());
}

TEST_CASE("a notch along an edge of elements cuts the contacts with facets and corners, and none with walls") {
  ThreeKindsOfContact bodies;
  // Around the upper right corner of the square, just off its edges.
  bodies.model.notches.push_back({.name = "right", .from = {1.01, -1.0}, .to = {1.01, 2.0}});
  GridContactDetector detector(skin);
  bodies.state = resting_state(bodies.model);
  detector.bond(bodies.model, bodies.state);
  CHECK(bodies.model.cut_facet_pairs == bodies.model.facet_pairs);
  CHECK(bodies.model.cut_corner_pairs == bodies.model.corner_pairs);
  CHECK(bodies.model.cut_particle_pairs.empty());
  CHECK(bodies.state.facet_contacts.bond[0] == BondState::unbonded);
  CHECK(bodies.state.corner_contacts.bond[0] == BondState::unbonded);
  CHECK(bodies.state.particle_contacts.bond[0] == BondState::bonded);
  bodies.add_forces();
  for (const Vector& force : bodies.state.particles.translation.force) CHECK(norm(force) == 0.0);

  Model model = empty_model();
  add_particle(model, {0.5, 0.09}, 0.1);
  add_wall(model, {1.0, 0.0}, {0.0, 0.0}, {.is_tied = true});
  model.notches.push_back({.name = "above the wall", .from = {0.0, 0.01}, .to = {1.0, 0.01}});
  State state = resting_state(model);
  GridContactDetector(skin).bond(model, state);
  REQUIRE(state.facet_contacts.size() == 1);
  CHECK(state.facet_contacts.bond[0] == BondState::bonded);
  CHECK(model.cut_facet_pairs.empty());
}
