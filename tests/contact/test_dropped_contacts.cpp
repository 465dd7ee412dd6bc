#include <doctest/doctest.h>

#include <cmath>

#include "contact/contact_forces.hpp"
#include "contact/dropped_contacts.hpp"
#include "contact/grid_contact_detector.hpp"
#include "support/hand_made_model.hpp"
#include "support/moved_bodies.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Two discs, a little apart at set-up.
struct TwoDiscs {
  Model model = empty_model();
  State state;
  GridContactDetector detector{1e-3};
  ContactForces<ParticlePairing> forces;

  TwoDiscs() {
    add_particle(model, {0.0, 0.0}, 0.1);
    add_particle(model, {0.2005, 0.0}, 0.1);
    state = resting_state(model);
    detector.bond(model, state);
  }
  void move(const Vector& displacement) {
    displace(state.particles.translation, 1, displacement);
    detector.update(model, state);
    clear_forces(state);
    forces.add_forces(model, state);
  }
  [[nodiscard]] double term(const std::string& name) const {
    double sum = 0.0;
    for (const auto& terms : {forces.energies(model, state), detector.energies(model, state)}) {
      for (const EnergyTerm& line : terms) sum += line.name == name ? line.value : 0.0;
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("what a dropped contact had spent stays in the ledger") {
  TwoDiscs discs;
  REQUIRE(discs.state.particle_contacts.size() == 1);
  CHECK(discs.state.particle_contacts.bond[0] == BondState::unbonded);
  discs.move({-6e-4, 0.0});
  for (int step = 1; step <= 10; ++step) discs.move({-6e-4, 1e-5 * step});
  const double friction = discs.term("friction");
  CHECK(friction > 0.0);
  // Opened within the list: the shear that was stored is friction work now, too.
  discs.move({1e-4, 1e-4});
  const double spent = discs.term("friction");
  CHECK(spent > friction);
  CHECK(discs.term("elastic_contacts") == 0.0);
  discs.move({0.01, 0.0});
  CHECK(discs.state.particle_contacts.size() == 0);
  CHECK(discs.term("friction") == doctest::Approx(spent).epsilon(1e-14));
  CHECK(discs.term("contacts_lost") == 0.0);
  // Found again it starts anew; the old work stays.
  discs.move({0.0, 0.0});
  CHECK(discs.state.particle_contacts.size() == 1);
  CHECK(discs.term("friction") == doctest::Approx(spent).epsilon(1e-14));
}

TEST_CASE("what a contact still stored when it was torn out of the list is booked as lost") {
  TwoDiscs discs;
  discs.move({-6e-4, 0.0});
  const double stored = discs.term("elastic_contacts");
  CHECK(stored == doctest::Approx(0.5 * 1e9 / 0.96 * 1e-8).epsilon(1e-6));
  discs.move({0.01, 0.0});
  CHECK(discs.term("elastic_contacts") == 0.0);
  CHECK(discs.term("contacts_lost") == doctest::Approx(stored).epsilon(1e-12));
}

TEST_CASE("what a contact brings that is found with an overlap is booked against the losses") {
  TwoDiscs discs;
  discs.move({0.01, 0.0});
  discs.move({-6e-4, 0.0});
  const double stored = discs.term("elastic_contacts");
  CHECK(stored > 0.0);
  CHECK(discs.term("contacts_lost") == doctest::Approx(-stored).epsilon(1e-12));
}

TEST_CASE("rows that no candidate keeps are the dropped ones") {
  TwoDiscs discs;
  const ContactTable& contacts = discs.state.particle_contacts;
  CHECK(dropped_rows(contacts, {}) == std::vector<std::size_t>{0});
  CHECK(dropped_rows(contacts, {{contact_law, 0, 1, 0}}).empty());
  CHECK(dropped_rows(contacts, {{contact_law, 0, 1, -1}}) == std::vector<std::size_t>{0});
}
