#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "contact/grid_contact_detector.hpp"
#include "core/error.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/hand_made_model.hpp"
#include "support/moved_bodies.hpp"
#include "support/random_numbers.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double skin = 0.02;

/// Discs of sizes 1 to 5 around a solid with re-entrant corners, all in random motion.
struct Swarm {
  RandomNumbers random{18};
  Model model = empty_model({.detection_gap = 0.0, .interface_gap = 0.0});
  State state;
  GridContactDetector detector{skin};
  Field<Vector> velocity;

  Swarm() {
    add_outline(model, {{0.0, 0.0}, {0.6, 0.0}, {0.6, 0.3}, {0.3, 0.3}, {0.3, 0.5}, {0.0, 0.6}});
    while (model.particles.size() < 150) {
      const Vector place = random.vector(1.0);
      const double radius = random.uniform(0.02, 0.1);
      const bool is_clear = place.x < -radius || place.y < -radius || place.x > 0.7 || place.y > 0.7;
      if (!is_clear) continue;
      add_particle(model, place, radius);
      velocity.push_back(random.vector(0.002));
    }
    state = resting_state(model);
    detector.bond(model, state);
    // Without bonds contacts come and go.
    for (ContactTable* contacts : {&state.particle_contacts, &state.facet_contacts, &state.corner_contacts}) {
      std::fill(contacts->bond.begin(), contacts->bond.end(), BondState::broken);
    }
  }

  void step() {
    for (std::size_t i = 0; i < model.particles.size(); ++i) {
      velocity[i] += random.vector(0.0004);
      displace(state.particles.translation, i, state.particles.translation.displacement[i] + velocity[i]);
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      displace(state.nodes.translation, i, state.nodes.translation.displacement[i] + random.vector(0.001));
    }
  }

  [[nodiscard]] Field<Vector> centres() const { return places(model.particles.position, state.particles.translation); }
  [[nodiscard]] Field<Vector> nodes() const { return places(model.nodes.position, state.nodes.translation); }

  static Field<Vector> places(const Field<Vector>& rest, const TranslationState& bodies) {
    Field<Vector> now(rest);
    for (std::size_t i = 0; i < now.size(); ++i) now[i] += bodies.displacement[i];
    return now;
  }
};

std::vector<SetupPair> listed(const ContactTable& contacts) {
  std::vector<SetupPair> pairs;
  for (std::size_t row = 0; row < contacts.size(); ++row) pairs.push_back({contacts.first[row], contacts.second[row]});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool is_in_order(const ContactTable& contacts) {
  for (std::size_t row = 1; row < contacts.size(); ++row) {
    if (std::tie(contacts.law[row - 1], contacts.first[row - 1], contacts.second[row - 1]) >=
        std::tie(contacts.law[row], contacts.first[row], contacts.second[row])) {
      return false;
    }
  }
  return true;
}

/// Whether the table of facets or corners holds a contact of the particle at one of these nodes.
bool has_contact_at(const Swarm& swarm, Index particle, const std::vector<Index>& nodes) {
  const auto is_one_of = [&](Index node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); };
  for (const SetupPair& pair : listed(swarm.state.facet_contacts)) {
    const auto& [i, j] = swarm.model.facets.nodes[pair.second];
    if (pair.first == particle && (is_one_of(i) || is_one_of(j))) return true;
  }
  for (const SetupPair& pair : listed(swarm.state.corner_contacts)) {
    if (pair.first == particle && is_one_of(pair.second)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("no touching pair is missed between updates of the list, in many steps of moving bodies") {
  Swarm swarm;
  std::size_t n_found = 0;
  int n_updates = 0;
  for (int step = 0; step < 600; ++step) {
    swarm.step();
    const bool is_update = swarm.detector.update(swarm.model, swarm.state);
    n_updates += is_update ? 1 : 0;
    const auto touching = reference::all_particle_pairs(swarm.centres(), swarm.model.particles.radius, 0.0);
    const auto list = listed(swarm.state.particle_contacts);
    REQUIRE(std::includes(list.begin(), list.end(), touching.begin(), touching.end()));
    n_found += touching.size();
    // A set-up pair with a gap below rounding may be listed a rounding farther.
    const auto near = reference::all_particle_pairs(swarm.centres(), swarm.model.particles.radius, 1.0001 * skin);
    if (is_update) REQUIRE(std::includes(near.begin(), near.end(), list.begin(), list.end()));
    REQUIRE(is_in_order(swarm.state.particle_contacts));
  }
  CHECK(n_updates > 30);
  CHECK(n_updates < 500);
  CHECK(swarm.state.search.n_updates == n_updates);
  CHECK(n_found > 20000);
}

TEST_CASE("no touching facet or corner is missed between updates of the list") {
  Swarm swarm;
  std::size_t n_found = 0;
  for (int step = 0; step < 600; ++step) {
    swarm.step();
    swarm.detector.update(swarm.model, swarm.state);
    const Field<Vector> nodes = swarm.nodes();
    const auto& facets = swarm.model.facets;
    for (const SetupPair& pair :
         reference::all_facet_pairs(facets, nodes, swarm.centres(), swarm.model.particles.radius, 0.0)) {
      const auto& ends = facets.nodes[pair.second];
      // Discs without forces wander through the solid; from behind a facet there is no skin.
      if (reference::place_on_facet(nodes[ends[0]], nodes[ends[1]], swarm.centres()[pair.first]).away <= 0.0) continue;
      // A particle that passes a corner between updates is still held by its neighbour there.
      REQUIRE(has_contact_at(swarm, pair.first, {ends.begin(), ends.end()}));
      ++n_found;
    }
    for (const SetupPair& pair :
         reference::all_corner_pairs(facets, nodes, swarm.centres(), swarm.model.particles.radius, 0.0)) {
      REQUIRE(has_contact_at(swarm, pair.first, {pair.second}));
      ++n_found;
    }
    REQUIRE(is_in_order(swarm.state.facet_contacts));
    REQUIRE(is_in_order(swarm.state.corner_contacts));
  }
  CHECK(n_found > 600);
}

TEST_CASE("an update leaves what kept contacts remember as it is") {
  Swarm swarm;
  std::map<SetupPair, double> marks;
  double mark = 0.0;
  int n_kept = 0;
  for (int step = 0; step < 300; ++step) {
    ContactTable& contacts = swarm.state.particle_contacts;
    marks.clear();
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      contacts.shear_displacement[row] = ++mark;
      marks[{contacts.first[row], contacts.second[row]}] = mark;
    }
    const auto before = contacts.rest_distance.size();
    swarm.step();
    if (!swarm.detector.update(swarm.model, swarm.state)) {
      REQUIRE(contacts.rest_distance.size() == before);
      continue;
    }
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      const auto known = marks.find({contacts.first[row], contacts.second[row]});
      REQUIRE(contacts.shear_displacement[row] == (known == marks.end() ? 0.0 : known->second));
      n_kept += known != marks.end() ? 1 : 0;
    }
  }
  CHECK(n_kept > 1000);
}

TEST_CASE("nothing is searched before a body has moved by half a skin") {
  Swarm swarm;
  displace(swarm.state.particles.translation, 3, {0.49 * skin, 0.0});
  CHECK_FALSE(swarm.detector.update(swarm.model, swarm.state));
  displace(swarm.state.nodes.translation, 1, {0.0, 0.51 * skin});
  CHECK(swarm.detector.update(swarm.model, swarm.state));
  CHECK_FALSE(swarm.detector.update(swarm.model, swarm.state));
}

TEST_CASE("a body whose position is not a number stops the run") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Swarm swarm;
  SUBCASE("particle") { displace(swarm.state.particles.translation, 3, {nan, 0.0}); }
  SUBCASE("node") { displace(swarm.state.nodes.translation, 1, {0.0, nan}); }
  CHECK_THROWS_AS(swarm.detector.update(swarm.model, swarm.state), DivergenceError);
}

TEST_CASE("what bodies can still go before an update is half the skin less what one has gone") {
  Swarm swarm;
  CHECK(swarm.detector.spare_travel(swarm.model, swarm.state) == 0.5 * skin);
  displace(swarm.state.particles.translation, 7, {0.3 * skin, 0.0});
  displace(swarm.state.nodes.translation, 2, {0.0, -0.4 * skin});
  CHECK(swarm.detector.spare_travel(swarm.model, swarm.state) == doctest::Approx(0.1 * skin));
  CHECK_FALSE(swarm.detector.update(swarm.model, swarm.state));
  displace(swarm.state.particles.translation, 3, {0.0, 0.6 * skin});
  CHECK(swarm.detector.spare_travel(swarm.model, swarm.state) < 0.0);
  CHECK(swarm.detector.update(swarm.model, swarm.state));
  CHECK(swarm.detector.spare_travel(swarm.model, swarm.state) == 0.5 * skin);
  displace(swarm.state.particles.translation, 3, {std::numeric_limits<double>::quiet_NaN(), 0.0});
  CHECK_FALSE(swarm.detector.spare_travel(swarm.model, swarm.state) > 0.0);
}
