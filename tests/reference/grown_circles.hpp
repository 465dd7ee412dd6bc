#pragma once

#include <limits>
#include <numeric>

#include "generation/obstacles.hpp"

namespace ligament::reference {

/// Growth of an empty circle that looks at all obstacles at every turn: first up to the walls, then up to all that is
/// in the way of that circle, and so on. The slow twin of grow_circle.
inline Circle grown_circle(const Obstacles& obstacles, const Circle& corner, std::size_t first, std::size_t second) {
  const auto side = [&](const Vector& point) {
    const Circle* a = obstacles.disc(first);
    const Circle* b = obstacles.disc(second);
    if (a == nullptr) return 0.0;
    return cross(b != nullptr ? b->centre - a->centre : std::get<LinearCondition>(obstacles[second]).normal,
                 point - a->centre);
  };
  Circle grown{corner.centre, std::numeric_limits<double>::infinity()};
  std::vector<std::size_t> others(obstacles.size() - obstacles.n_discs());
  std::iota(others.begin(), others.end(), obstacles.n_discs());
  while (!others.empty()) {
    const double before = grown.radius;
    for (const std::size_t other : others) {
      if (other == first || other == second) continue;
      for (const Circle& circle : tangent_circles({obstacles[first], obstacles[second], obstacles[other]})) {
        if (side(circle.centre) * side(corner.centre) < 0.0) continue;
        if (circle.radius > corner.radius && circle.radius < grown.radius) grown = circle;
      }
    }
    if (grown.radius == before) return corner;
    others.clear();
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (obstacles.is_in_the_way(i, grown)) others.push_back(i);
    }
  }
  return grown;
}

/// Those from all corners of the holes that circles of this radius find between discs and walls, where every pair is
/// tried.
inline std::vector<Circle> grown_circles(const Obstacles& obstacles, double radius) {
  std::vector<Circle> grown;
  for (std::size_t first = 0; first < obstacles.size(); ++first) {
    for (std::size_t second = first + 1; second < obstacles.size(); ++second) {
      for (const Circle& corner : tangent_circles({obstacles[first], obstacles[second], has_radius(radius)})) {
        bool is_free = true;
        for (std::size_t i = 0; i < obstacles.size(); ++i) is_free = is_free && !obstacles.is_in_the_way(i, corner);
        if (is_free) grown.push_back(grown_circle(obstacles, corner, first, second));
      }
    }
  }
  return grown;
}

}  // namespace ligament::reference
