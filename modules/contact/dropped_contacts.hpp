#pragma once

#include <vector>

#include "contact/contact_rows.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// Rows of a table that none of the candidates keeps.
std::vector<std::size_t> dropped_rows(const ContactTable& contacts, const std::vector<ContactCandidate>& candidates);

/// Energies of one contact.
ContactEnergies contact_energies(const Model& model, const ContactTable& contacts, std::size_t row);

/// What a contact without bond stores (J) when it is open by this much and carries its present shear force.
double free_contact_energy(const ContactTable& contacts, std::size_t row, double opening);

/// Takes energies of a contact that is gone into the sums that dropped_energies() reads back.
void book_dropped_contact(const ContactEnergies& energies, EnergyLedger& ledger);

/// Takes note of energy (J) that a contact holds when it is found.
void book_found_contact(double energy, EnergyLedger& ledger);

/// Opens the lines of the ledger for the above.
void open_dropped_energies(EnergyLedger& ledger);

/// What contacts dropped so far had spent, and, as `elastic_normal`, what they still held less what found ones brought.
ContactEnergies dropped_energies(const EnergyLedger& ledger);

}  // namespace ligament
