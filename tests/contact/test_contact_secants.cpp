#include <doctest/doctest.h>

#include "contact/contact_secants.hpp"

using namespace ligament;

namespace {

/// A contact with k_n = 4 and k_s = 2.
ContactTable contact(BondState bond, double opening, double normal_force, double slip = 0.0, double shear_force = 0.0) {
  ContactTable table;
  table.normal_stiffness = {4.0};
  table.shear_stiffness = {2.0};
  table.bond = {bond};
  table.opening = {opening};
  table.normal_force = {normal_force};
  table.shear_displacement = {slip};
  table.shear_force = {shear_force};
  return table;
}

ContactMemory::Table memory_of(const ContactTable& table) {
  ContactMemory::Table memory;
  memory.opening = table.opening;
  memory.normal_force = table.normal_force;
  memory.shear_displacement = table.shear_displacement;
  memory.shear_force = table.shear_force;
  return memory;
}

double normal(const ContactTable& now, const ContactTable& before) {
  return normal_secant(values_of(now, 0), memory_of(before), 0);
}
double shear(const ContactTable& now, const ContactTable& before) {
  return shear_secant(values_of(now, 0), memory_of(before), 0);
}

}  // namespace

TEST_CASE("normal secants: whole, softened, unloaded elastically, open") {
  using enum BondState;
  const ContactTable rest = contact(bonded, 0.0, 0.0);
  CHECK(normal(contact(bonded, 0.5, -2.0), rest) == 4.0);
  CHECK(normal(contact(broken, -0.5, 2.0), rest) == 4.0);
  CHECK(normal(contact(unbonded, 0.0, 0.0), rest) == 4.0);
  CHECK(normal(contact(softening, 0.5, -1.0), contact(softening, 0.4, -1.2)) == 2.0);
  CHECK(normal(contact(softening, 0.4, -0.6), contact(softening, 0.5, -1.0)) == doctest::Approx(4.0));
  CHECK(normal(contact(broken, 0.5, 0.0), rest) == 0.0);
  CHECK(normal(contact(unbonded, 0.5, 0.0), rest) == 0.0);
}

TEST_CASE("shear secants: what slip leaves of the spring") {
  using enum BondState;
  const ContactTable rest = contact(unbonded, -0.5, 2.0);
  CHECK(shear(contact(bonded, 0.0, 0.0, 0.25, -0.5), rest) == 2.0);
  CHECK(shear(contact(unbonded, -0.5, 2.0, 0.25, -0.5), rest) == 2.0);
  CHECK(shear(contact(unbonded, -0.5, 2.0, 0.5, -0.5), rest) == 1.0);
  CHECK(shear(contact(broken, 0.5, 0.0, 0.5, 0.0), rest) == 0.0);
  // The spring of before, 0.5, and a slip of 0.25 against it.
  CHECK(shear(contact(softening, 0.5, -1.0, 0.25, -0.75), contact(softening, 0.5, -1.0, 0.0, -0.5)) == 1.5);
  CHECK(shear(contact(softening, 0.5, -1.0), contact(softening, 0.5, -1.0)) == 2.0);
  CHECK(shear(contact(broken, 0.5, 0.0), contact(broken, 0.5, 0.0)) == 0.0);
}

TEST_CASE("a contact that slides and bears no shear has no shear secant") {
  using enum BondState;
  const ContactTable rest = contact(bonded, 0.0, 0.0);
  CHECK(shear(rest, rest) == 2.0);
  CHECK(shear(contact(bonded, 0.1, -0.4, 0.25, 0.0), rest) == 0.0);
}
