#include "generation/void_elimination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "generation/disc_growth.hpp"
#include "generation/point_cells.hpp"
#include "generation/voids.hpp"

namespace ligament {
namespace {

/// Moves points by the same vector.
Field<Vector> shifted(Field<Vector> points, const Vector& shift) {
  for (Vector& point : points) point += shift;
  return points;
}

/// The box without its border strip, and the centres as they lie in it.
struct Inside {
  Vector size;
  Field<Vector> centres;

  Inside(const Packing& packing, const Vector& whole, double border)
      : size(whole - uniform_vector(2.0 * border)), centres(shifted(packing.position, uniform_vector(-border))) {}

  [[nodiscard]] bool is_empty() const { return std::min(size.x, size.y) <= 0.0; }
};

std::vector<Circle> voids_to_fill(const Packing& packing, const Vector& size, const VoidFilling& filling) {
  const Inside inside(packing, size, filling.border());
  if (inside.is_empty()) return {};
  std::vector<Circle> voids = find_voids(inside.centres, packing.radius, inside.size, filling.smallest_void);
  for (Circle& hole : voids) hole.centre += uniform_vector(filling.border());
  return voids;
}

/// Fills the voids, the largest first, those left out that the discs before have made too small.
void fill(Packing& packing, const Vector& size, const std::vector<Circle>& voids, const VoidFilling& filling) {
  constexpr double rounding = 1e-6;
  const double reach = (filling.disc_radius + filling.smallest_void) * (1.0 + rounding);
  const double spacing = std::sqrt(size.x * size.y / static_cast<double>(voids.size()));
  PointCells filled(size, std::max(reach, spacing));
  for (const Circle& hole : voids) {
    const bool is_too_small = filled.any_near(hole.centre, [&](Index disc) {
      return norm(filled.points()[disc] - hole.centre) - filling.disc_radius <= filling.smallest_void;
    });
    if (is_too_small) continue;
    filled.add(hole.centre);
    packing.position.push_back(hole.centre);
    packing.radius.push_back(filling.disc_radius);
  }
}

}  // namespace

std::size_t eliminate_voids(Packing& packing, const Vector& size, const VoidFilling& filling) {
  constexpr int most_rounds = 1000;
  const std::size_t n_before = packing.size();
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Circle> voids = voids_to_fill(packing, size, filling);
    if (voids.empty()) return packing.size() - n_before;
    fill(packing, size, voids, filling);
    settle(packing, size);
  }
  throw InputError(
      fmt::format("voids above {:g} m are left after {} rounds of filling them with discs of {:g} m radius: a larger "
                  "'smallest_void_radius' would do",
                  filling.smallest_void, most_rounds, filling.disc_radius));
}

double largest_void_left(const Packing& packing, const Vector& size, const VoidFilling& filling) {
  const Inside inside(packing, size, filling.border());
  if (inside.is_empty()) return 0.0;
  // choice: not below half the limit, since there are ever more voids the smaller they are.
  return largest_void(inside.centres, packing.radius, inside.size, 0.5 * filling.smallest_void);
}

}  // namespace ligament
