#include "contact/dropped_contacts.hpp"

#include <algorithm>

#include "contact/law_ranges.hpp"

namespace ligament {
namespace {

constexpr const char* held = "dropped.held";
constexpr const char* tension = "dropped.fracture_tension";
constexpr const char* shear = "dropped.fracture_shear";
constexpr const char* friction = "dropped.friction";

}  // namespace

std::vector<std::size_t> dropped_rows(const ContactTable& contacts, const std::vector<ContactCandidate>& candidates) {
  std::vector<bool> is_kept(contacts.size(), false);
  for (const ContactCandidate& candidate : candidates) {
    if (candidate.old_row >= 0) is_kept[candidate.old_row] = true;
  }
  std::vector<std::size_t> dropped;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (!is_kept[row]) dropped.push_back(row);
  }
  return dropped;
}

ContactEnergies contact_energies(const Model& model, const ContactTable& contacts, std::size_t row) {
  const Index law = contacts.law[row];
  return block_energies(model, contacts, {model.laws[law].law.get(), law, row, row + 1});
}

double free_contact_energy(const ContactTable& contacts, std::size_t row, double opening) {
  const double overlap = std::max(0.0, -opening);
  return 0.5 * contacts.normal_stiffness[row] * overlap * overlap +
         0.5 * contacts.shear_force[row] * contacts.shear_force[row] / contacts.shear_stiffness[row];
}

void open_dropped_energies(EnergyLedger& ledger) {
  for (const char* name : {held, tension, shear, friction}) ledger.open(name);
}

void book_dropped_contact(const ContactEnergies& energies, EnergyLedger& ledger) {
  ledger[ledger.open(held)].add(energies.stored());
  ledger[ledger.open(tension)].add(energies.fracture_tension);
  ledger[ledger.open(shear)].add(energies.fracture_shear);
  ledger[ledger.open(friction)].add(energies.friction);
}

void book_found_contact(double energy, EnergyLedger& ledger) { ledger[ledger.open(held)].add(-energy); }

ContactEnergies dropped_energies(const EnergyLedger& ledger) {
  return {.elastic_normal = ledger.total(held),
          .fracture_tension = ledger.total(tension),
          .fracture_shear = ledger.total(shear),
          .friction = ledger.total(friction)};
}

}  // namespace ligament
