#include "generation/tangent_circles.hpp"

#include <cmath>

namespace ligament {
namespace {

/// Centre and radius as a point in space. With a disc among the conditions, centres are counted from that of the disc.
struct Point {
  Vector centre;
  double radius = 0.0;
};

Point operator+(const Point& a, const Point& b) { return {a.centre + b.centre, a.radius + b.radius}; }
Point operator*(double s, const Point& a) { return {s * a.centre, s * a.radius}; }
double dot(const Point& a, const Point& b) { return dot(a.centre, b.centre) + a.radius * b.radius; }
Point cross(const Point& a, const Point& b) {
  return {{a.centre.y * b.radius - a.radius * b.centre.y, a.radius * b.centre.x - a.centre.x * b.radius},
          cross(a.centre, b.centre)};
}

/// The points u with normal · u = value.
struct Plane {
  Point normal;
  double value = 0.0;
};

/// The points origin + s direction.
struct Line {
  Point origin;
  Point direction;

  [[nodiscard]] Point at(double s) const { return origin + s * direction; }
};

Line intersection(const Plane& a, const Plane& b) {
  const Point direction = cross(a.normal, b.normal);
  const Point sum = a.value * cross(b.normal, direction) + b.value * cross(direction, a.normal);
  return {1.0 / dot(direction, direction) * sum, direction};
}

Plane plane_of(const LinearCondition& condition, const Vector& origin) {
  return {{condition.normal, condition.of_radius}, condition.value - dot(condition.normal, origin)};
}

/// |c - p| = R + ρ less |c| = R0 + ρ, both squared: linear.
Plane plane_of(const Circle& disc, const Circle& anchor) {
  const Vector apart = disc.centre - anchor.centre;
  const double squares = dot(apart, apart) - disc.radius * disc.radius + anchor.radius * anchor.radius;
  return {{apart, disc.radius - anchor.radius}, 0.5 * squares};
}

/// Where a line meets the cone |c| = R0 + ρ: roots of a s² + 2 h s + e = 0, so written that neither loses its digits.
std::vector<Point> meet(const Line& line, double anchor_radius) {
  const Point from{line.origin.centre, line.origin.radius + anchor_radius};
  const Point& along = line.direction;
  const double a = dot(along.centre, along.centre) - along.radius * along.radius;
  const double h = dot(from.centre, along.centre) - from.radius * along.radius;
  const double e = dot(from.centre, from.centre) - from.radius * from.radius;
  const double discriminant = h * h - a * e;
  if (!(discriminant >= 0.0)) return {};
  const double q = -(h + std::copysign(std::sqrt(discriminant), h));
  return {line.at(q / a), line.at(e / q)};
}

std::vector<Point> meet(const Line& line, const Plane& plane) {
  const double s = (plane.value - dot(plane.normal, line.origin)) / dot(plane.normal, line.direction);
  return {line.at(s)};
}

std::vector<Point> solve(const std::array<CircleCondition, 3>& conditions, const Circle* anchor) {
  std::vector<Plane> planes;
  for (const CircleCondition& condition : conditions) {
    const auto* disc = std::get_if<Circle>(&condition);
    if (disc == nullptr) {
      planes.push_back(plane_of(std::get<LinearCondition>(condition), anchor != nullptr ? anchor->centre : Vector{}));
    } else if (disc != anchor) {
      planes.push_back(plane_of(*disc, *anchor));
    }
  }
  const Line line = intersection(planes[0], planes[1]);
  return anchor != nullptr ? meet(line, anchor->radius) : meet(line, planes[2]);
}

}  // namespace

std::vector<Circle> tangent_circles(const std::array<CircleCondition, 3>& conditions) {
  const Circle* anchor = nullptr;
  for (const CircleCondition& condition : conditions) {
    if (anchor == nullptr) anchor = std::get_if<Circle>(&condition);
  }
  std::vector<Circle> circles;
  for (const Point& point : solve(conditions, anchor)) {
    // The equations have solutions that touch from inside, too, and none that are finite if conditions are parallel.
    if (!is_finite(point.centre) || !(point.radius > 0.0) || !std::isfinite(point.radius)) continue;
    circles.push_back({anchor != nullptr ? anchor->centre + point.centre : point.centre, point.radius});
  }
  return circles;
}

}  // namespace ligament
