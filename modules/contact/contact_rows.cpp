#include "contact/contact_rows.hpp"

#include <algorithm>
#include <tuple>

#include "contact/law_ranges.hpp"
#include "core/fields.hpp"

namespace ligament {
namespace {

std::vector<HistoryColumn> carry_history(const Model& model, const ContactTable& old,
                                         const std::vector<ContactCandidate>& candidates) {
  std::vector<HistoryColumn> history = make_history(model);
  const auto begin = history_begin(model);
  for (const ContactCandidate& candidate : candidates) {
    for (std::size_t column = begin[candidate.law]; column < begin[candidate.law + 1]; ++column) {
      // A contact keeps its law for life, so that an old row has a place in the same columns.
      history[column].values.push_back(
          candidate.old_row < 0 ? history[column].initial_value
                                : old.history[column].values[candidate.old_row - old.law_begin[candidate.law]]);
    }
  }
  return history;
}

Field<Index> find_law_begin(const Model& model, const std::vector<ContactCandidate>& candidates) {
  Field<Index> begin(model.laws.size() + 1, 0);
  for (const ContactCandidate& candidate : candidates) ++begin[candidate.law + 1];
  for (std::size_t law = 0; law < model.laws.size(); ++law) begin[law + 1] += begin[law];
  return begin;
}

}  // namespace

std::vector<std::size_t> rebuild_rows(const Model& model, ContactTable& contacts,
                                      std::vector<ContactCandidate> candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const ContactCandidate& a, const ContactCandidate& b) {
    return std::tie(a.law, a.first, a.second) < std::tie(b.law, b.first, b.second);
  });
  contacts.history = carry_history(model, contacts, candidates);
  contacts.law_begin = find_law_begin(model, candidates);
  visit_rows(contacts, [&]<class T>(const char*, Field<T>& field, FieldRole) {
    Field<T> rows(candidates.size(), T{});
    for (std::size_t row = 0; row < candidates.size(); ++row) {
      if (candidates[row].old_row >= 0) rows[row] = field[candidates[row].old_row];
    }
    field = std::move(rows);
  });
  std::vector<std::size_t> new_rows;
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    if (candidates[row].old_row >= 0) continue;
    contacts.law[row] = candidates[row].law;
    contacts.first[row] = candidates[row].first;
    contacts.second[row] = candidates[row].second;
    new_rows.push_back(row);
  }
  return new_rows;
}

}  // namespace ligament
