#include <doctest/doctest.h>

#include "contact/contact_rows.hpp"
#include "contact/law_ranges.hpp"
#include "support/hand_made_model.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// Rows (law, first, second) 0 1 2, 0 3 4, 1 0 1, 1 2 5, told apart by their openings and the history of law 1.
ContactTable filled_table(const Model& model) {
  ContactTable contacts;
  rebuild_rows(model, contacts,
               {{contact_law, 2, 5, -1}, {bond_law, 1, 2, -1}, {contact_law, 0, 1, -1}, {bond_law, 3, 4, -1}});
  for (std::size_t row = 0; row < 4; ++row) {
    contacts.opening[row] = static_cast<double>(row + 1);
    contacts.shear_force[row] = 10.0 * static_cast<double>(row + 1);
    contacts.bond[row] = row < 2 ? BondState::bonded : BondState::unbonded;
  }
  contacts.history[0].values = {0.3, 0.4};
  return contacts;
}

}  // namespace

TEST_CASE("rows are sorted by law, first, second, whatever the order of the candidates") {
  const Model model = empty_model();
  const ContactTable contacts = filled_table(model);
  CHECK(contacts.law == Field<Index>{0, 0, 1, 1});
  CHECK(contacts.first == Field<Index>{1, 3, 0, 2});
  CHECK(contacts.second == Field<Index>{2, 4, 1, 5});
  CHECK(contacts.law_begin == Field<Index>{0, 2, 4});
}

TEST_CASE("history has one column per variable, as long as the law has contacts") {
  const Model model = empty_model();
  ContactTable contacts;
  rebuild_rows(model, contacts, {{contact_law, 0, 1, -1}, {bond_law, 0, 2, -1}});
  REQUIRE(contacts.history.size() == 1);
  CHECK(contacts.history[0].name == "rock.contact.friction_work");
  CHECK(contacts.history[0].values == Field<double>{0.0});
}

TEST_CASE("kept contacts take everything along, new ones are zero, lost ones are gone") {
  const Model model = empty_model();
  ContactTable contacts = filled_table(model);
  const auto new_rows = rebuild_rows(
      model, contacts, {{bond_law, 3, 4, 1}, {contact_law, 2, 5, 3}, {contact_law, 2, 3, -1}, {bond_law, 0, 9, -1}});
  CHECK(new_rows == std::vector<std::size_t>{0, 2});
  CHECK(contacts.first == Field<Index>{0, 3, 2, 2});
  CHECK(contacts.opening == Field<double>{0.0, 2.0, 0.0, 4.0});
  CHECK(contacts.shear_force == Field<ShearVector>{0.0, 20.0, 0.0, 40.0});
  CHECK(contacts.bond[1] == BondState::bonded);
  CHECK(contacts.bond[0] == BondState::unbonded);
  CHECK(contacts.history[0].values == Field<double>{0.0, 0.4});
  CHECK(contacts.law_begin == Field<Index>{0, 2, 4});
}

TEST_CASE("a table can be emptied") {
  const Model model = empty_model();
  ContactTable contacts = filled_table(model);
  CHECK(rebuild_rows(model, contacts, {}).empty());
  CHECK(contacts.size() == 0);
  CHECK(contacts.bond.empty());
  CHECK(contacts.history[0].values.empty());
  CHECK(contacts.law_begin == Field<Index>{0, 0, 0});
}

TEST_CASE("blocks cover the range of every law once and never more than a block") {
  const Model model = empty_model();
  ContactTable contacts;
  std::vector<ContactCandidate> candidates;
  for (Index i = 0; i < 1300; ++i) candidates.push_back({i < 1200 ? bond_law : contact_law, i, i + 1, -1});
  rebuild_rows(model, contacts, candidates);
  std::size_t next = 0;
  for (const LawBlock& block : law_blocks(model, contacts)) {
    CHECK(block.begin == next);
    CHECK(block.size() <= contact_block_size);
    CHECK(contacts.law[block.begin] == block.law_row);
    CHECK(contacts.law[block.end - 1] == block.law_row);
    next = block.end;
  }
  CHECK(next == 1300);
}
