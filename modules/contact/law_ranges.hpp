#pragma once

#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// Physics walks contacts in blocks of this size: what passes between kinematics, law and forces then stays in the
/// first cache.
inline constexpr std::size_t contact_block_size = 128;

/// Rows [begin, end) of a contact table that one law serves.
struct LawBlock {
  const ConstitutiveLaw* law = nullptr;
  Index law_row = 0;
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// The range of every law cut into blocks; where they begin depends on the table alone.
std::vector<LawBlock> law_blocks(const Model& model, const ContactTable& contacts);

/// Where the history columns of each law begin in ContactTable::history; one entry more than laws.
std::vector<std::size_t> history_begin(const Model& model);

/// Empty columns for every history variable of every law.
std::vector<HistoryColumn> make_history(const Model& model);

/// The history arrays of a law, each from the given row of the table on.
template <class Table>
auto history_pointers(const Model& model, Table& contacts, Index law, std::size_t row) {
  using Pointer = std::conditional_t<std::is_const_v<Table>, const double*, double*>;
  // Asked for at every block of every step: no table of all laws, and no memory for laws without history.
  std::size_t column = 0;
  for (Index before = 0; before < law; ++before) column += model.laws[before].n_history;
  std::vector<Pointer> pointers(model.laws[law].n_history);
  for (Pointer& pointer : pointers) {
    pointer = contacts.history[column++].values.data() + (row - contacts.law_begin[law]);
  }
  return pointers;
}

/// Energies of the contacts in a block, from their state.
ContactEnergies block_energies(const Model& model, const ContactTable& contacts, const LawBlock& block);

/// Energies of all contacts of a table.
ContactEnergies table_energies(const Model& model, const ContactTable& contacts);

}  // namespace ligament
