#pragma once

#include "contact/contact_secants.hpp"
#include "contact/law_ranges.hpp"
#include "core/contact_trial.hpp"

/// Contacts as springs that are tried one by one, apart from the bodies they join.
namespace ligament {

/// Adds the contacts of a table that may not bear what their springs would; its springs are numbered from
/// `first_spring` on.
inline void add_loose_contacts(const ContactTable& contacts, const ContactMemory::Table& before,
                               std::size_t first_spring, std::vector<LooseContact>& loose) {
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (contacts.bond[row] == BondState::bonded && !values_of(contacts, row).is_smooth()) continue;
    loose.push_back({.spring = first_spring + 2 * row,
                     .stretch = {contacts.opening[row] - before.opening[row],
                                 contacts.shear_displacement[row] - before.shear_displacement[row]},
                     .pull = {-contacts.normal_force[row], -contacts.shear_force[row]},
                     .pull_before = {-before.normal_force[row], -before.shear_force[row]}});
  }
}

/// What the law answers where a contact opens and slides by so much from where it was before.
inline SpringAnswer try_contact(const Model& model, const ContactTable& contacts, const ContactMemory::Table& before,
                                std::size_t row, const SpringPair& stretch) {
  const Index law = contacts.law[row];
  ContactValues now = values_of(contacts, row);
  now.opening = before.opening[row] + stretch[0];
  now.shear_displacement = before.shear_displacement[row] + stretch[1];
  now.normal_force = before.normal_force[row];
  now.shear_force = before.shear_force[row];
  now.bond = before.bond[row];
  std::vector<double> history;
  const std::size_t first_column = history_begin(model)[law];
  for (std::size_t k = 0; k < model.laws[law].n_history; ++k) {
    history.push_back(before.history[first_column + k][row - contacts.law_begin[law]]);
  }
  std::vector<double*> pointers;
  for (double& value : history) pointers.push_back(&value);

  const auto one = [](auto& value) { return std::span(&value, 1); };
  const ShearVector slip = stretch[1];
  const double& opening = now.opening;
  model.laws[law].law->evaluate({one(opening), one(slip), one(contacts.normal_stiffness[row]),
                                 one(contacts.shear_stiffness[row]), one(contacts.area[row]), one(now.normal_force),
                                 one(now.shear_force), one(now.bond), pointers});
  return {{-now.normal_force, -now.shear_force}, {normal_secant(now, before, row), shear_secant(now, before, row)}};
}

}  // namespace ligament
