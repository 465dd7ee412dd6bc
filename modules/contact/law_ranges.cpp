#include "contact/law_ranges.hpp"

#include <algorithm>

namespace ligament {

std::vector<LawBlock> law_blocks(const Model& model, const ContactTable& contacts) {
  std::vector<LawBlock> blocks;
  blocks.reserve(model.laws.size() + contacts.size() / contact_block_size);
  for (std::size_t law = 0; law < model.laws.size(); ++law) {
    const auto range_end = static_cast<std::size_t>(contacts.law_begin[law + 1]);
    for (auto begin = static_cast<std::size_t>(contacts.law_begin[law]); begin < range_end;
         begin += contact_block_size) {
      blocks.push_back(
          {model.laws[law].law.get(), static_cast<Index>(law), begin, std::min(begin + contact_block_size, range_end)});
    }
  }
  return blocks;
}

std::vector<std::size_t> history_begin(const Model& model) {
  std::vector<std::size_t> begin{0};
  for (const LawBinding& binding : model.laws) begin.push_back(begin.back() + binding.n_history);
  return begin;
}

std::vector<HistoryColumn> make_history(const Model& model) {
  std::vector<HistoryColumn> columns;
  for (const LawBinding& binding : model.laws) {
    for (const HistoryVariable& variable : binding.law->history()) {
      columns.push_back({binding.name + "." + variable.name, variable.initial_value, {}});
    }
  }
  return columns;
}

ContactEnergies block_energies(const Model& model, const ContactTable& contacts, const LawBlock& block) {
  const auto history = history_pointers(model, contacts, block.law_row, block.begin);
  const auto part = [&](const auto& field) { return std::span(field).subspan(block.begin, block.size()); };
  return block.law->energies({part(contacts.opening), part(contacts.normal_stiffness), part(contacts.shear_stiffness),
                              part(contacts.area), part(contacts.normal_force), part(contacts.shear_force),
                              part(contacts.bond), history});
}

ContactEnergies table_energies(const Model& model, const ContactTable& contacts) {
  ContactEnergies total;
  for (const LawBlock& block : law_blocks(model, contacts)) total += block_energies(model, contacts, block);
  return total;
}

}  // namespace ligament
