#pragma once

#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// A row that a contact table is to have: its key, and the row it has now, or -1 if the contact is new.
struct ContactCandidate {
  Index law = 0;
  Index first = 0;
  Index second = 0;
  Index old_row = -1;
};

/// Gives the table the rows asked for, sorted by (law, first, second). Kept contacts take their state along; new rows
/// are zero, their history initial. Returns the numbers of the new rows.
std::vector<std::size_t> rebuild_rows(const Model& model, ContactTable& contacts,
                                      std::vector<ContactCandidate> candidates);

}  // namespace ligament
