#include "run/plane_meeting.hpp"

#include <algorithm>

namespace ligament {
namespace {

/// Where along a piece a point is, 0 at `from` and 1 at `to`, also beyond them.
double position_along(const Vector& from, const Vector& to, const Vector& point) {
  const Vector piece = to - from;
  const double square = dot(piece, piece);
  return square > 0.0 ? dot(point - from, piece) / square : 0.5;
}

Vector closest_on(const std::array<Vector, 2>& piece, const Vector& point) {
  const double position = std::clamp(position_along(piece[0], piece[1], point), 0.0, 1.0);
  return piece[0] + position * (piece[1] - piece[0]);
}

std::optional<Vector> crossing(const std::array<Vector, 2>& a, const std::array<Vector, 2>& b) {
  const Vector along_a = a[1] - a[0];
  const Vector along_b = b[1] - b[0];
  const double sine = cross(along_a, along_b);
  if (sine == 0.0) return {};
  const double at_a = cross(b[0] - a[0], along_b) / sine;
  const double at_b = cross(b[0] - a[0], along_a) / sine;
  if (at_a < 0.0 || at_a > 1.0 || at_b < 0.0 || at_b > 1.0) return {};
  return a[0] + at_a * along_a;
}

}  // namespace

Meeting meeting(const CrackPlane& a, const CrackPlane& b) {
  const auto ends_a = a.ends();
  const auto ends_b = b.ends();
  if (const auto point = crossing(ends_a, ends_b)) return {0.0, *point};
  // Pieces that do not cross come closest at an end of one of them.
  std::optional<Meeting> closest;
  const auto try_end = [&](const Vector& end, const std::array<Vector, 2>& other) {
    const Vector point = closest_on(other, end);
    const double gap = norm(point - end);
    if (!closest || gap < closest->gap) closest = Meeting{gap, 0.5 * (end + point)};
  };
  for (const Vector& end : ends_a) try_end(end, ends_b);
  for (const Vector& end : ends_b) try_end(end, ends_a);
  return *closest;
}

std::optional<double> distance_beside(const Field<Vector>& path, const Vector& point) {
  std::optional<double> smallest;
  bool is_beyond = false;
  bool is_left = true;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double distance = norm(closest_on({path[i], path[i + 1]}, point) - point);
    if (smallest && distance >= *smallest) continue;
    smallest = distance;
    const double position = position_along(path[i], path[i + 1], point);
    is_beyond = (i == 0 && position < 0.0) || (i + 2 == path.size() && position > 1.0);
    is_left = cross(path[i + 1] - path[i], point - path[i]) >= 0.0;
  }
  if (!smallest || is_beyond) return {};
  return is_left ? *smallest : -*smallest;
}

}  // namespace ligament
