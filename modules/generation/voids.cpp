#include "generation/voids.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/cell_grid.hpp"

namespace ligament {
namespace {

/// Discs and the four walls, numbered in this order, and the empty circles of some radius and more between them.
class Obstacles {
 public:
  Obstacles(const Field<Vector>& centres, const Field<double>& radii, const Vector& size, double smallest)
      : n_discs_(centres.size()),
        largest_disc_(radii.empty() ? 0.0 : *std::max_element(radii.begin(), radii.end())),
        smallest_(smallest),
        grid_(centres, largest_disc_ + 2.0 * smallest) {
    for (std::size_t i = 0; i < n_discs_; ++i) obstacles_.emplace_back(Circle{centres[i], radii[i]});
    for (int axis = 0; axis < dimension; ++axis) {
      Vector normal;
      set_component(normal, axis, 1.0);
      obstacles_.emplace_back(touches_wall(normal, 0.0));
      obstacles_.emplace_back(touches_wall(-normal, -component(size, axis)));
    }
  }

  /// Empty circles that have grown from all corners of holes.
  [[nodiscard]] std::vector<Circle> grown_circles() const {
    std::vector<Circle> grown;
    for (std::size_t first = 0; first < obstacles_.size(); ++first) {
      for (const std::size_t second : near_ones(first)) {
        for (const Circle& corner : tangent_circles({obstacles_[first], obstacles_[second], has_radius(smallest_)})) {
          if (in_the_way(corner).empty()) grown.push_back(grow(corner, first, second));
        }
      }
    }
    return grown;
  }

 private:
  [[nodiscard]] const Circle* disc(std::size_t i) const { return std::get_if<Circle>(&obstacles_[i]); }

  [[nodiscard]] double gap(std::size_t i, const Circle& circle) const {
    if (const Circle* other = disc(i)) return norm(circle.centre - other->centre) - other->radius - circle.radius;
    const auto& wall = std::get<LinearCondition>(obstacles_[i]);
    return dot(wall.normal, circle.centre) - wall.value - circle.radius;
  }

  /// Obstacles nearer to a circle than this, in ascending order of cells; walls come last.
  [[nodiscard]] std::vector<std::size_t> within(const Circle& circle, double reach) const {
    std::vector<std::size_t> found;
    const Vector range = uniform_vector(circle.radius + largest_disc_ + reach);
    grid_.visit_box(circle.centre - range, circle.centre + range, [&](Index i) {
      if (gap(static_cast<std::size_t>(i), circle) < reach) found.push_back(static_cast<std::size_t>(i));
    });
    for (std::size_t wall = n_discs_; wall < obstacles_.size(); ++wall) {
      if (gap(wall, circle) < reach) found.push_back(wall);
    }
    return found;
  }

  /// Obstacles of higher number that a circle of the smallest radius can touch together with this one.
  [[nodiscard]] std::vector<std::size_t> near_ones(std::size_t first) const {
    std::vector<std::size_t> found;
    if (const Circle* circle = disc(first)) {
      found = within(*circle, 2.0 * smallest_);
    } else {
      for (std::size_t wall = n_discs_; wall < obstacles_.size(); ++wall) found.push_back(wall);
    }
    std::erase_if(found, [&](std::size_t second) { return second <= first; });
    return found;
  }

  [[nodiscard]] std::vector<std::size_t> in_the_way(const Circle& circle) const {
    constexpr double rounding = 1e-9;
    return within(circle, -rounding * circle.radius);
  }

  /// On which side of the narrowest place between two obstacles a point lies: a circle in touch with both grows as it
  /// moves away from there.
  [[nodiscard]] double side(std::size_t first, std::size_t second, const Vector& point) const {
    const Circle* a = disc(first);
    if (a == nullptr) return 0.0;  // two walls: there is no narrowest place
    const Circle* b = disc(second);
    const Vector across = b != nullptr ? b->centre - a->centre : std::get<LinearCondition>(obstacles_[second]).normal;
    return cross(across, point - a->centre);
  }

  /// A corner, grown in touch with its two obstacles until it meets a third.
  [[nodiscard]] Circle grow(const Circle& corner, std::size_t first, std::size_t second) const {
    const double corner_side = side(first, second, corner.centre);
    Circle grown{corner.centre, std::numeric_limits<double>::infinity()};
    std::vector<std::size_t> others{n_discs_, n_discs_ + 1, n_discs_ + 2, n_discs_ + 3};
    while (!others.empty()) {
      const double before = grown.radius;
      for (const std::size_t other : others) {
        if (other == first || other == second) continue;
        for (const Circle& circle : tangent_circles({obstacles_[first], obstacles_[second], obstacles_[other]})) {
          const bool same_side = side(first, second, circle.centre) * corner_side >= 0.0;
          if (same_side && circle.radius > corner.radius && circle.radius < grown.radius) grown = circle;
        }
      }
      // Nothing to meet is left but by rounding: the hole is as small as the corner.
      if (grown.radius == before) return corner;
      others = in_the_way(grown);
    }
    return grown;
  }

  std::vector<CircleCondition> obstacles_;
  std::size_t n_discs_;
  double largest_disc_;
  double smallest_;
  CellGrid grid_;
};

}  // namespace

std::vector<Circle> find_voids(const Field<Vector>& centres, const Field<double>& radii, const Vector& size,
                               double smallest) {
  std::vector<Circle> voids = Obstacles(centres, radii, size, smallest).grown_circles();
  const auto key = [](const Circle& circle) { return std::tie(circle.radius, circle.centre.x, circle.centre.y); };
  std::sort(voids.begin(), voids.end(), [&](const Circle& a, const Circle& b) { return key(b) < key(a); });
  return voids;
}

double largest_void(const Field<Vector>& centres, const Field<double>& radii, const Vector& size, double smallest) {
  constexpr double rounding = 1e-9;
  double largest = 0.0;
  for (double limit = smallest;; limit = largest * (1.0 + rounding)) {
    const std::vector<Circle> voids = find_voids(centres, radii, size, limit);
    if (voids.empty()) return largest;
    largest = voids.front().radius;
  }
}

}  // namespace ligament
