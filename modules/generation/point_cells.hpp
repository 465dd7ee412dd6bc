#pragma once

#include <algorithm>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

/// Points put one by one into square cells of the box [0, size].
class PointCells {
 public:
  /// Cells of this width (m).
  PointCells(const Vector& size, double cell_size)
      : cell_size_(cell_size),
        n_x_(number_of_cells(size.x)),
        n_y_(number_of_cells(size.y)),
        newest_(n_x_ * n_y_, none) {}

  void add(const Vector& point) {
    Index& newest = newest_[cell_along(point.y, n_y_) * n_x_ + cell_along(point.x, n_x_)];
    older_.push_back(newest);
    newest = static_cast<Index>(points_.size());
    points_.push_back(point);
  }

  /// Whether the condition holds for the number of any point in the cell of this place or in one beside it. All points
  /// nearer than the width of a cell are asked for, but for rounding.
  template <class Condition>
  [[nodiscard]] bool any_near(const Vector& place, Condition&& condition) const {
    const std::size_t x = cell_along(place.x, n_x_);
    const std::size_t y = cell_along(place.y, n_y_);
    for (std::size_t j = y - std::min<std::size_t>(y, 1); j <= std::min(y + 1, n_y_ - 1); ++j) {
      for (std::size_t i = x - std::min<std::size_t>(x, 1); i <= std::min(x + 1, n_x_ - 1); ++i) {
        for (Index point = newest_[j * n_x_ + i]; point != none; point = older_[point]) {
          if (condition(point)) return true;
        }
      }
    }
    return false;
  }

  /// The points in the order in which they came.
  [[nodiscard]] const Field<Vector>& points() const { return points_; }

 private:
  static constexpr Index none = -1;

  [[nodiscard]] std::size_t number_of_cells(double length) const {
    return static_cast<std::size_t>(length / cell_size_) + 1;
  }
  [[nodiscard]] std::size_t cell_along(double position, std::size_t n_cells) const {
    return std::min(static_cast<std::size_t>(position / cell_size_), n_cells - 1);
  }

  double cell_size_;
  std::size_t n_x_;
  std::size_t n_y_;
  std::vector<Index> newest_;  ///< of the points in a cell
  std::vector<Index> older_;   ///< the point that was the newest of its cell before this one
  Field<Vector> points_;
};

}  // namespace ligament
