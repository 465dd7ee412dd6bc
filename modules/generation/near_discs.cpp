#include "generation/near_discs.hpp"

#include <algorithm>

namespace ligament {

// The wide skin is where searches and the sifting of candidates take least time together.
NearDiscs::NearDiscs(const Field<double>& radii, double skin)
    : radii_(radii),
      largest_radius_(*std::max_element(radii.begin(), radii.end())),
      skin_(skin),
      wide_skin_(10.0 * skin) {}

void NearDiscs::update(const Field<Vector>& centres) {
  const CellGrid grid(centres, 2.0 * largest_radius_ + skin_);
  if (is_exhausted(centres)) search(centres, grid);
  list(centres, grid);
}

/// Whether pairs within the skin may be missing among the candidates.
bool NearDiscs::is_exhausted(const Field<Vector>& centres) const {
  if (centres_when_searched_.empty()) return true;
  double farthest = 0.0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    farthest = std::max(farthest, largest_component(centres[i] - centres_when_searched_[i]));
  }
  return farthest > most_moved_in(wide_skin_ - skin_);
}

void NearDiscs::search(const Field<Vector>& centres, const CellGrid& grid) {
  centres_when_searched_ = centres;
  candidates_.clear();
  begin_.assign(1, 0);
  for (std::size_t first = 0; first < centres.size(); ++first) {
    const double radius = radii_[first] + wide_skin_;
    const Vector range = uniform_vector(radius + largest_radius_);
    grid.visit_box(centres[first] - range, centres[first] + range, [&](Index second) {
      const Vector apart = centres[second] - centres[first];
      const double reach = radius + radii_[second];
      if (dot(apart, apart) < reach * reach && static_cast<std::size_t>(second) > first) candidates_.push_back(second);
    });
    begin_.push_back(candidates_.size());
  }
}

void NearDiscs::list(const Field<Vector>& centres, const CellGrid& grid) {
  rank_.resize(centres.size());
  Index rank = 0;
  for (const Index disc : grid.points()) rank_[disc] = rank++;
  pairs_.resize(candidates_.size());
  std::size_t n_pairs = 0;
  for (std::size_t first = 0; first < centres.size(); ++first) {
    const std::size_t begin = n_pairs;
    for (std::size_t k = begin_[first]; k < begin_[first + 1]; ++k) {
      const Index second = candidates_[k];
      const Vector apart = centres[second] - centres[first];
      const double reach = radii_[first] + radii_[second] + skin_;
      // Written down and kept or not, since about as many are as are not: a branch would often be foretold wrongly.
      pairs_[n_pairs] = {static_cast<Index>(first), second};
      n_pairs += dot(apart, apart) < reach * reach ? 1 : 0;
    }
    sort({pairs_.data() + begin, n_pairs - begin});
  }
  pairs_.resize(n_pairs);
}

/// By insertion: few have left their place since the search.
void NearDiscs::sort(std::span<DiscPair> pairs) const {
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    const DiscPair pair = pairs[k];
    std::size_t place = k;
    for (; place > 0 && rank_[pairs[place - 1].second] > rank_[pair.second]; --place) pairs[place] = pairs[place - 1];
    pairs[place] = pair;
  }
}

}  // namespace ligament
