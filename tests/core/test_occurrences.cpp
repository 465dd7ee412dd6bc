#include <doctest/doctest.h>

#include "core/occurrences.hpp"

using namespace ligament;

TEST_CASE("places of every body, in the order of the list") {
  const Field<Index> list{2, 0, -1, 2, 3, 2, 0};
  const Occurrences found = find_occurrences(list, 5);
  const auto places = [&](std::size_t body) { return Field<Index>(found.of(body).begin(), found.of(body).end()); };
  CHECK(places(0) == Field<Index>{1, 6});
  CHECK(places(1).empty());
  CHECK(places(2) == Field<Index>{0, 3, 5});
  CHECK(places(3) == Field<Index>{4});
  CHECK(places(4).empty());
}

TEST_CASE("an empty list names nobody") {
  const Occurrences found = find_occurrences({}, 2);
  CHECK(found.of(0).empty());
  CHECK(found.of(1).empty());
  CHECK(Occurrences{}.places.empty());
}
