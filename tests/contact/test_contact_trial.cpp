#include <doctest/doctest.h>

#include "constitutive/batch_law.hpp"
#include "contact/contact_trial.hpp"
#include "support/hand_made_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Two bodies that press on each other.
struct Pressed {
  Model model = empty_model();
  ContactTable table;
  ContactMemory::Table before;

  Pressed() {
    model.laws[0] = {"rock.contact", std::make_shared<BatchLaw<Frictional>>(Frictional{0.5}), Frictional::n_history};
    table.law = {0};
    table.law_begin = {0, 1};
    table.first = {0};
    table.normal_stiffness = {4.0};
    table.shear_stiffness = {2.0};
    table.area = {1.0};
    table.opening = {-0.1};
    table.shear_displacement = {0.3};
    table.normal_force = {0.4};
    table.shear_force = {0.0};
    table.bond = {BondState::unbonded};
    before.opening = table.opening;
    before.shear_displacement = table.shear_displacement;
    before.normal_force = table.normal_force;
    before.shear_force = table.shear_force;
    before.bond = table.bond;
    before.history.assign(Frictional::n_history, Field<double>{0.0});
  }
  [[nodiscard]] SpringAnswer answer(const SpringPair& stretch) const {
    return try_contact(model, table, before, 0, stretch);
  }
};

}  // namespace

TEST_CASE("a contact that is tried alone answers as its law does, and stays as it is") {
  const Pressed contact;
  const SpringAnswer sticks = contact.answer({-0.1, 0.05});
  CHECK(sticks.pull[0] == doctest::Approx(-0.8));
  CHECK(sticks.pull[1] == doctest::Approx(0.1));
  CHECK(sticks.secant[0] == 4.0);
  CHECK(sticks.secant[1] == doctest::Approx(2.0));
  const SpringAnswer slides = contact.answer({0.0, 1.0});
  CHECK(slides.pull[1] == doctest::Approx(0.2));
  CHECK(slides.secant[1] == doctest::Approx(0.2));
  const SpringAnswer opens = contact.answer({0.2, 0.0});
  CHECK(opens.pull[0] == 0.0);
  CHECK(opens.secant[0] == 0.0);
  CHECK(contact.table.normal_force[0] == 0.4);
}

TEST_CASE("contacts that may not bear what their springs would are told with what they have done") {
  Pressed contact;
  contact.table.opening[0] = -0.2;
  contact.table.normal_force[0] = 0.8;
  contact.table.shear_displacement[0] = 0.5;
  std::vector<LooseContact> loose;
  add_loose_contacts(contact.table, contact.before, 6, loose);
  REQUIRE(loose.size() == 1);
  CHECK(loose[0].spring == 6);
  CHECK(loose[0].stretch[0] == doctest::Approx(-0.1));
  CHECK(loose[0].stretch[1] == doctest::Approx(0.2));
  CHECK(loose[0].pull[0] == -0.8);
  CHECK(loose[0].pull_before[0] == -0.4);

  // A whole bond bears them, unless it slides on a law without shear.
  contact.table.bond[0] = BondState::bonded;
  add_loose_contacts(contact.table, contact.before, 6, loose);
  CHECK(loose.size() == 2);
  contact.table.shear_force[0] = -0.4;
  add_loose_contacts(contact.table, contact.before, 6, loose);
  CHECK(loose.size() == 2);
}
