#include <doctest/doctest.h>

#include <set>

#include "contact/contact_forces.hpp"
#include "contact/contact_rows.hpp"
#include "core/state_hash.hpp"
#include "support/hand_made_model.hpp"
#include "support/random_numbers.hpp"
#include "support/resting_state.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using namespace ligament::support;

/// One thread brings the forces to the bodies contact by contact; many fetch them body by body. Both add in the same
/// order, so that every bit is the same.
namespace {

constexpr Index n_particles = 300;
constexpr Index n_facets = 40;

Index pick(RandomNumbers& random, Index count) { return static_cast<Index>(random.uniform(0.0, count)); }

/// Bodies anywhere, in random motion.
struct RandomBodies {
  RandomNumbers random{7};
  Model model = empty_model();
  State state;

  RandomBodies() {
    for (Index i = 0; i < n_particles; ++i) add_particle(model, random.vector(5.0), random.uniform(0.1, 0.3));
    std::vector<Vector> corners(n_facets);
    for (Vector& corner : corners) corner = random.vector(5.0);
    add_outline(model, corners);
    state = resting_state(model);
    for (TranslationState* bodies : {&state.particles.translation, &state.nodes.translation}) {
      for (Vector& u : bodies->displacement) u = random.vector(0.01);
      for (Vector& du : bodies->increment) du = random.vector(0.001);
      for (Vector& force : bodies->force) force = random.vector(1e3);
    }
    for (Rotation& turn : state.particles.rotation.increment) turn = random.uniform(-0.01, 0.01);
  }

  /// Contacts of random bodies and both laws.
  void fill(ContactTable& contacts, int count, Index n_second) {
    std::set<SetupPair> pairs;
    while (static_cast<int>(pairs.size()) < count) {
      const SetupPair pair{pick(random, n_particles), pick(random, n_second)};
      if (&contacts != &state.particle_contacts || pair.first < pair.second) pairs.insert(pair);
    }
    std::vector<ContactCandidate> rows;
    for (const SetupPair& pair : pairs) rows.push_back({pick(random, 2), pair.first, pair.second, -1});
    contacts = {};
    for (const std::size_t row : rebuild_rows(model, contacts, rows)) {
      contacts.rest_distance[row] = random.uniform(0.5, 2.0);
      contacts.initial_gap[row] = random.uniform(-0.1, 0.1);
      contacts.normal_stiffness[row] = random.uniform(1e6, 1e9);
      contacts.shear_stiffness[row] = random.uniform(1e6, 1e9);
      contacts.area[row] = 1.0;
    }
  }
};

template <class Pairing>
std::string forces_hash(ContactForces<Pairing>& forces, const Model& model, State state, int n_threads) {
  const SharedLoops shared(n_threads);
  forces.add_forces(model, state);
  return state_hash(state);
}

template <class Pairing>
void check_same_bits(int n_contacts, Index n_second) {
  RandomBodies bodies;
  ContactForces<Pairing> forces;
  const std::string at_rest = state_hash(bodies.state);
  // The second table has as many contacts as the first, the third fewer: what is known of the bodies' contacts must
  // follow.
  for (const int count : {n_contacts, n_contacts, n_contacts / 3}) {
    bodies.fill(Pairing::table(bodies.state), count, n_second);
    const std::string alone = forces_hash(forces, bodies.model, bodies.state, 1);
    CHECK(alone != at_rest);
    for (const int n_threads : {2, 3, 8}) CHECK(forces_hash(forces, bodies.model, bodies.state, n_threads) == alone);
  }
}

}  // namespace

TEST_SUITE_BEGIN("threads");

TEST_CASE("contacts of particles: the same bits for every number of threads") {
  check_same_bits<ParticlePairing>(3000, n_particles);
}

TEST_CASE("contacts with facets: the same bits for every number of threads") {
  check_same_bits<FacetPairing>(1500, n_facets);
}

TEST_CASE("contacts with corners: the same bits for every number of threads") {
  check_same_bits<CornerPairing>(1500, n_facets);
}

TEST_SUITE_END();
