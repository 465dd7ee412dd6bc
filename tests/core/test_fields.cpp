#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "core/fields.hpp"
#include "filled_state.hpp"

using namespace ligament;

namespace {

/// Where a visited field lies in its table.
struct Place {
  std::ptrdiff_t begin = 0;
  std::ptrdiff_t end = 0;
};

template <class Table>
std::vector<Place> visited_places(Table& table) {
  std::vector<Place> places;
  visit_fields(table, [&](const std::string&, auto& field, FieldRole) {
    const auto begin = reinterpret_cast<const std::byte*>(&field) - reinterpret_cast<const std::byte*>(&table);
    places.push_back({begin, begin + static_cast<std::ptrdiff_t>(sizeof(field))});
  });
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.begin < b.begin; });
  return places;
}

std::ptrdiff_t size_of_all(const std::vector<Place>& places) {
  std::ptrdiff_t sum = 0;
  for (const Place& place : places) sum += place.end - place.begin;
  return sum;
}

bool overlap(const std::vector<Place>& places) {
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].begin < places[i - 1].end) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("every field of the state is visited once") {
  State state;
  const std::vector<Place> places = visited_places(state);
  CHECK(places.front().begin == 0);
  CHECK(places.back().end == static_cast<std::ptrdiff_t>(sizeof(State)));
  CHECK_FALSE(overlap(places));
  // Not fields themselves: the lists of history columns, whose values are visited, and the names in the ledger.
  const std::size_t lists = 4 * sizeof(ContactTable::history) + sizeof(EnergyLedger::names);
  CHECK(size_of_all(places) == static_cast<std::ptrdiff_t>(sizeof(State) - lists));
}

TEST_CASE("fields have names of their own") {
  State state = filled_state();
  std::set<std::string> names;
  std::size_t n_fields = 0;
  visit_fields(state, [&](const std::string& name, auto&, FieldRole) {
    ++n_fields;
    names.insert(name);
  });
  CHECK(names.size() == n_fields);
  CHECK(names.contains("clock.step"));
  CHECK(names.contains("particles.rotation_increment"));
  CHECK(names.contains("facet_contacts.history.law.damage"));
}

TEST_CASE("only what the audit, the gauges and the count of breaks read off is sampled") {
  State state = filled_state();
  std::set<std::string> sampled;
  visit_fields(state, [&](const std::string& name, auto&, FieldRole role) {
    if (role == FieldRole::sampled) sampled.insert(name);
  });
  CHECK(sampled == std::set<std::string>{"ledger.scale", "ledger.largest_error", "stage.peaks", "stage.readings",
                                         "stage.force_mismatch", "cracks.n_tension", "cracks.n_shear"});
}

TEST_CASE("a constant state is visited the same way") {
  State state = filled_state();
  std::vector<std::string> names;
  std::vector<std::string> names_of_constant;
  visit_fields(state, [&](const std::string& name, auto&, FieldRole) { names.push_back(name); });
  visit_fields(std::as_const(state),
               [&](const std::string& name, const auto&, FieldRole) { names_of_constant.push_back(name); });
  CHECK(names == names_of_constant);
}

TEST_CASE("rows of a contact table are all fields with one value per contact") {
  ContactTable table;
  std::size_t n_rows = 0;
  visit_rows(table, [&](const std::string&, auto&, FieldRole) { ++n_rows; });
  CHECK(n_rows * sizeof(Field<double>) ==
        sizeof(ContactTable) - sizeof(ContactTable::law_begin) - sizeof(ContactTable::history));
}
