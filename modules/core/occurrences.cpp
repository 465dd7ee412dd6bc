#include "core/occurrences.hpp"

#include <numeric>

namespace ligament {

Occurrences find_occurrences(std::span<const Index> list, std::size_t n_bodies) {
  Occurrences found;
  found.begin.assign(n_bodies + 1, 0);
  for (const Index body : list) {
    if (body >= 0) ++found.begin[body + 1];
  }
  std::partial_sum(found.begin.begin(), found.begin.end(), found.begin.begin());
  found.places.resize(found.begin.back());
  Field<Index> next(found.begin.begin(), found.begin.end() - 1);
  for (std::size_t place = 0; place < list.size(); ++place) {
    if (list[place] >= 0) found.places[next[list[place]]++] = static_cast<Index>(place);
  }
  return found;
}

}  // namespace ligament
