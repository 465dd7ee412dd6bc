#include "generation/voids.hpp"

#include <algorithm>
#include <tuple>

#include "generation/obstacles.hpp"
#include "generation/void_growth.hpp"

namespace ligament {
namespace {

/// Obstacles of higher number that a circle of this radius can touch together with this one.
std::vector<std::size_t> near_ones(const Obstacles& obstacles, std::size_t first, double radius) {
  std::vector<std::size_t> found;
  if (const Circle* circle = obstacles.disc(first)) {
    found = obstacles.within(*circle, 2.0 * radius);
  } else {
    for (std::size_t wall = obstacles.n_discs(); wall < obstacles.size(); ++wall) found.push_back(wall);
  }
  std::erase_if(found, [&](std::size_t second) { return second <= first; });
  return found;
}

/// Empty circles that have grown from all corners of holes.
std::vector<Circle> grown_circles(const Obstacles& obstacles, double smallest) {
  std::vector<Circle> grown;
  for (std::size_t first = 0; first < obstacles.size(); ++first) {
    for (const std::size_t second : near_ones(obstacles, first, smallest)) {
      for (const Circle& corner : tangent_circles({obstacles[first], obstacles[second], has_radius(smallest)})) {
        if (!obstacles.in_the_way(corner).empty()) continue;
        grown.push_back(grow_circle(obstacles, corner, first, second));
      }
    }
  }
  return grown;
}

}  // namespace

std::vector<Circle> find_voids(const Field<Vector>& centres, const Field<double>& radii, const Vector& size,
                               double smallest) {
  std::vector<Circle> voids = grown_circles(Obstacles(centres, radii, size, smallest), smallest);
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
