#include "generation/disc_insertion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"

namespace ligament {
namespace {

constexpr Index none = -1;

/// Discs in square cells as wide as the largest of them, so that only neighbouring cells can hold one that overlaps.
class InsertedDiscs {
 public:
  InsertedDiscs(std::span<const double> radii, const Vector& size)
      : radii_(radii),
        cell_size_(2.0 * radii[0]),
        n_x_(number_of_cells(size.x)),
        n_y_(number_of_cells(size.y)),
        newest_(n_x_ * n_y_, none) {}

  /// Whether a disc at this place would overlap none that is there.
  [[nodiscard]] bool has_room(const Vector& place, double radius) const {
    const std::size_t x = cell_along(place.x, n_x_);
    const std::size_t y = cell_along(place.y, n_y_);
    for (std::size_t j = y - std::min<std::size_t>(y, 1); j <= std::min(y + 1, n_y_ - 1); ++j) {
      for (std::size_t i = x - std::min<std::size_t>(x, 1); i <= std::min(x + 1, n_x_ - 1); ++i) {
        if (overlaps_one_of(newest_[j * n_x_ + i], place, radius)) return false;
      }
    }
    return true;
  }

  void add(const Vector& place) {
    Index& newest = newest_[cell_along(place.y, n_y_) * n_x_ + cell_along(place.x, n_x_)];
    older_.push_back(newest);
    newest = static_cast<Index>(centres_.size());
    centres_.push_back(place);
  }

  [[nodiscard]] Field<Vector> take_centres() { return std::move(centres_); }

 private:
  [[nodiscard]] std::size_t number_of_cells(double length) const {
    return static_cast<std::size_t>(length / cell_size_) + 1;
  }
  [[nodiscard]] std::size_t cell_along(double position, std::size_t n_cells) const {
    return std::min(static_cast<std::size_t>(position / cell_size_), n_cells - 1);
  }
  [[nodiscard]] bool overlaps_one_of(Index disc, const Vector& place, double radius) const {
    for (; disc != none; disc = older_[disc]) {
      const Vector apart = place - centres_[disc];
      const double reach = radius + radii_[disc];
      if (dot(apart, apart) < reach * reach) return true;
    }
    return false;
  }

  std::span<const double> radii_;
  double cell_size_;
  std::size_t n_x_;
  std::size_t n_y_;
  std::vector<Index> newest_;  ///< of the discs in a cell
  std::vector<Index> older_;   ///< the disc that was the newest of its cell before this one
  Field<Vector> centres_;
};

Vector find_room(const InsertedDiscs& discs, double radius, const Vector& size, RandomNumbers& random) {
  constexpr int most_trials = 100000;
  for (int trial = 0; trial < most_trials; ++trial) {
    const double x = random.uniform(radius, size.x - radius);
    const Vector place{x, random.uniform(radius, size.y - radius)};
    if (discs.has_room(place, radius)) return place;
  }
  throw InputError(
      fmt::format("a disc of radius {:.6g} m found no room in {} trials: fewer discs or a larger zone "
                  "would do",
                  radius, most_trials));
}

}  // namespace

Field<Vector> insert_discs(std::span<const double> radii, const Vector& size, RandomNumbers& random) {
  if (radii.empty()) return {};
  InsertedDiscs discs(radii, size);
  for (const double radius : radii) discs.add(find_room(discs, radius, size, random));
  return discs.take_centres();
}

}  // namespace ligament
