#include "build/notched_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ligament {
namespace {

/// A range of positions along an axis (m).
struct Range {
  double low = 0.0;
  double high = 0.0;
};

using Corners = std::array<Vector, 4>;

Corners corners_of(const Rectangle& box) {
  return {box.from, Vector{box.to.x, box.from.y}, box.to, Vector{box.from.x, box.to.y}};
}

Range range_along(const Corners& corners, const Vector& axis) {
  Range range{dot(corners[0], axis), dot(corners[0], axis)};
  for (const Vector& corner : corners) {
    range.low = std::min(range.low, dot(corner, axis));
    range.high = std::max(range.high, dot(corner, axis));
  }
  return range;
}

/// The slit as a rectangle of its own directions.
class Slit {
 public:
  Slit(const Notch& notch, double tolerance) : tolerance_(tolerance) {
    along_ = (notch.to - notch.from) / norm(notch.to - notch.from);
    const Vector half = 0.5 * notch.width * tangent(along_);
    corners_ = {notch.from - half, notch.to - half, notch.to + half, notch.from + half};
  }

  /// Whether both have points inside in common: no axis of either separates them.
  [[nodiscard]] bool meets(const Rectangle& element) const {
    const std::array<Vector, 4> axes{Vector{1.0, 0.0}, Vector{0.0, 1.0}, along_, tangent(along_)};
    return std::all_of(axes.begin(), axes.end(), [&](const Vector& axis) {
      const Range slit = range_along(corners_, axis);
      const Range other = range_along(corners_of(element), axis);
      return slit.low < other.high - tolerance_ && other.low < slit.high - tolerance_;
    });
  }

  [[nodiscard]] bool contains(const Rectangle& element) const {
    const std::array<Vector, 2> axes{along_, tangent(along_)};
    return std::all_of(axes.begin(), axes.end(), [&](const Vector& axis) {
      const Range slit = range_along(corners_, axis);
      const Range other = range_along(corners_of(element), axis);
      return slit.low <= other.low + tolerance_ && other.high <= slit.high + tolerance_;
    });
  }

  /// Whether the slit, without width, lies on a part of an edge.
  [[nodiscard]] bool runs_along(const Vector& from, const Vector& to) const {
    const Vector start = from - corners_[0];
    const Vector end = to - corners_[0];
    if (std::abs(cross(along_, start)) > tolerance_ || std::abs(cross(along_, end)) > tolerance_) return false;
    const double length = dot(along_, corners_[1] - corners_[0]);
    const double low = std::min(dot(along_, start), dot(along_, end));
    const double high = std::max(dot(along_, start), dot(along_, end));
    return std::min(high, length) - std::max(low, 0.0) > tolerance_;
  }

 private:
  double tolerance_;
  Vector along_;
  Corners corners_;
};

/// The elements of a grid that are not in its holes, by column and row.
class Elements {
 public:
  Elements(const GridLines& lines, const std::vector<Rectangle>& holes) : lines_(lines), holes_(holes) {}

  [[nodiscard]] std::size_t n_columns() const { return lines_.x.size() - 1; }
  [[nodiscard]] std::size_t n_rows() const { return lines_.y.size() - 1; }
  [[nodiscard]] Rectangle box(std::size_t column, std::size_t row) const {
    return {{lines_.x[column], lines_.y[row]}, {lines_.x[column + 1], lines_.y[row + 1]}};
  }
  [[nodiscard]] bool exists(std::size_t column, std::size_t row) const {
    if (column >= n_columns() || row >= n_rows()) return false;
    const Vector centre = 0.5 * (box(column, row).from + box(column, row).to);
    return std::none_of(holes_.begin(), holes_.end(), [&](const Rectangle& hole) {
      return centre.x > hole.from.x && centre.x < hole.to.x && centre.y > hole.from.y && centre.y < hole.to.y;
    });
  }

 private:
  const GridLines& lines_;
  const std::vector<Rectangle>& holes_;
};

}  // namespace

NotchedElements notched_elements(const Notch& notch, const GridLines& lines, const std::vector<Rectangle>& holes) {
  const double tolerance = 1e-9 * std::max(lines.x.back() - lines.x.front(), lines.y.back() - lines.y.front());
  const Slit slit(notch, tolerance);
  const Elements elements(lines, holes);
  NotchedElements found;
  for (std::size_t row = 0; row < elements.n_rows(); ++row) {
    for (std::size_t column = 0; column < elements.n_columns(); ++column) {
      if (!elements.exists(column, row)) continue;
      const Rectangle box = elements.box(column, row);
      if (notch.width > 0.0 && slit.contains(box)) {
        found.taken.push_back(box);
      } else if (slit.meets(box)) {
        found.cuts_into_one = true;
      }
      if (notch.width > 0.0) continue;
      const bool parts_from_right = elements.exists(column + 1, row) && slit.runs_along({box.to.x, box.from.y}, box.to);
      const bool parts_from_above = elements.exists(column, row + 1) && slit.runs_along({box.from.x, box.to.y}, box.to);
      found.parts_two = found.parts_two || parts_from_right || parts_from_above;
    }
  }
  return found;
}

}  // namespace ligament
