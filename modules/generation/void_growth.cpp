#include "generation/void_growth.hpp"

#include <array>
#include <limits>
#include <span>

namespace ligament {
namespace {

class Growth {
 public:
  Growth(const Obstacles& obstacles, const Circle& corner, std::size_t first, std::size_t second)
      : obstacles_(obstacles), corner_(corner), first_(first), second_(second), corner_side_(side(corner.centre)) {}

  [[nodiscard]] Circle grown() const {
    const std::size_t n_discs = obstacles_.n_discs();
    const Circle unlimited{corner_.centre, std::numeric_limits<double>::infinity()};
    Circle grown = until_met(unlimited, std::array{n_discs, n_discs + 1, n_discs + 2, n_discs + 3});
    // Nothing to meet is left but by rounding: the hole is as small as the corner.
    if (grown.radius == unlimited.radius) return corner_;
    grown = until_met_near(grown);
    for (;;) {
      const std::vector<std::size_t> others = obstacles_.in_the_way(grown);
      if (others.empty()) return grown;
      const double before = grown.radius;
      grown = until_met(grown, others);
      if (grown.radius == before) return corner_;
    }
  }

 private:
  /// On which side of the narrowest place between the two obstacles a point lies: a circle in touch with both grows as
  /// it moves away from there.
  [[nodiscard]] double side(const Vector& point) const {
    const Circle* a = obstacles_.disc(first_);
    if (a == nullptr) return 0.0;  // two walls: there is no narrowest place
    const Circle* b = obstacles_.disc(second_);
    const Vector across = b != nullptr ? b->centre - a->centre : std::get<LinearCondition>(obstacles_[second_]).normal;
    return cross(across, point - a->centre);
  }

  /// The smallest circle, larger than the corner and smaller than `limit`, that meets one of the others; else `limit`.
  [[nodiscard]] Circle until_met(const Circle& limit, std::span<const std::size_t> others) const {
    Circle grown = limit;
    for (const std::size_t other : others) {
      if (other == first_ || other == second_) continue;
      for (const Circle& circle : tangent_circles({obstacles_[first_], obstacles_[second_], obstacles_[other]})) {
        const bool same_side = side(circle.centre) * corner_side_ >= 0.0;
        if (same_side && circle.radius > corner_.radius && circle.radius < grown.radius) grown = circle;
      }
    }
    return grown;
  }

  /// The same of all that is in the way of a circle `limit` that may be as large as the box, found among what is near.
  /// What a circle meets is no farther than its diameter from the disc that it touches, so that others, farther away,
  /// can only be met by larger circles.
  [[nodiscard]] Circle until_met_near(const Circle& limit) const {
    constexpr double first_reach = 4.0;  // of radii of the corner
    constexpr double rounding = 1e-6;
    const Circle* anchor = smaller_disc();
    if (anchor == nullptr) return limit;
    for (double reach = first_reach * corner_.radius; reach < limit.radius; reach *= 2.0) {
      std::vector<std::size_t> others = obstacles_.within(*anchor, reach);
      std::erase_if(others, [&](std::size_t other) { return !obstacles_.is_in_the_way(other, limit); });
      const Circle grown = until_met(limit, others);
      if (2.0 * grown.radius * (1.0 + rounding) < reach) return grown;
    }
    return limit;
  }

  [[nodiscard]] const Circle* smaller_disc() const {
    const Circle* a = obstacles_.disc(first_);
    const Circle* b = obstacles_.disc(second_);
    return a != nullptr && (b == nullptr || a->radius < b->radius) ? a : b;
  }

  const Obstacles& obstacles_;
  const Circle& corner_;
  std::size_t first_;
  std::size_t second_;
  double corner_side_;
};

}  // namespace

Circle grow_circle(const Obstacles& obstacles, const Circle& corner, std::size_t first, std::size_t second) {
  return Growth(obstacles, corner, first, second).grown();
}

}  // namespace ligament
