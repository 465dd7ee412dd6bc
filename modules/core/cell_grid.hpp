#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

/// Points sorted into square cells; answers which of them may lie inside a box.
class CellGrid {
 public:
  /// Cells are at least `cell_size` wide (m), wider if the points lie so far apart that cells would outnumber them.
  /// Throws DivergenceError if a position is not finite.
  CellGrid(std::span<const Vector> positions, double cell_size);

  /// Calls visit(index) for every point in the cells that the box [low, high] touches, in a fixed order.
  template <class Visit>
  void visit_box(const Vector& low, const Vector& high, Visit&& visit) const {
    const Cell first = cell_at(low);
    const Cell last = cell_at(high);
    Cell cell = first;
    for (;;) {
      const std::size_t number = number_of(cell);
      for (std::size_t k = begin_[number]; k < begin_[number + 1]; ++k) visit(points_[k]);
      int axis = 0;
      while (axis < dimension && cell[axis] == last[axis]) {
        cell[axis] = first[axis];
        ++axis;
      }
      if (axis == dimension) return;
      ++cell[axis];
    }
  }

  /// All points in that order.
  [[nodiscard]] std::span<const Index> points() const { return points_; }

 private:
  using Cell = std::array<std::size_t, dimension>;

  void choose_cells(std::span<const Vector> positions, double cell_size);
  void sort_points(std::span<const Vector> positions);
  /// The cell of a place, or the nearest one if it lies outside of the grid.
  [[nodiscard]] Cell cell_at(const Vector& place) const;
  [[nodiscard]] std::size_t number_of(const Cell& cell) const;

  Vector origin_;
  double cell_size_ = 1.0;
  Cell n_cells_{};
  std::vector<std::size_t> begin_;  ///< of each cell in points_
  std::vector<Index> points_;
};

}  // namespace ligament
