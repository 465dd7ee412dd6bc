#include "generation/disc_insertion.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "generation/point_cells.hpp"

namespace ligament {
namespace {

/// Discs in cells as wide as the largest of them, so that only neighbouring cells can hold one that overlaps.
class InsertedDiscs {
 public:
  InsertedDiscs(std::span<const double> radii, const Vector& size) : radii_(radii), cells_(size, 2.0 * radii[0]) {}

  /// Whether a disc at this place would overlap none that is there.
  [[nodiscard]] bool has_room(const Vector& place, double radius) const {
    return !cells_.any_near(place, [&](Index disc) {
      const Vector apart = place - cells_.points()[disc];
      const double reach = radius + radii_[disc];
      return dot(apart, apart) < reach * reach;
    });
  }

  void add(const Vector& place) { cells_.add(place); }

  [[nodiscard]] const Field<Vector>& centres() const { return cells_.points(); }

 private:
  std::span<const double> radii_;
  PointCells cells_;
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
  return discs.centres();
}

}  // namespace ligament
