#include "core/cell_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/error.hpp"

namespace ligament {

CellGrid::CellGrid(std::span<const Vector> positions, double cell_size) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_finite(positions[i]))
      throw DivergenceError(fmt::format("the position of particle row {} is not finite", i));
  }
  choose_cells(positions, cell_size);
  sort_points(positions);
}

void CellGrid::choose_cells(std::span<const Vector> positions, double cell_size) {
  Vector low = positions.empty() ? Vector{} : positions[0];
  Vector high = low;
  for (const Vector& position : positions) {
    for (int axis = 0; axis < dimension; ++axis) {
      set_component(low, axis, std::min(component(low, axis), component(position, axis)));
      set_component(high, axis, std::max(component(high, axis), component(position, axis)));
    }
  }
  origin_ = low;
  const double most_cells = 4.0 * static_cast<double>(positions.size()) + 16.0;
  for (cell_size_ = cell_size;; cell_size_ *= 2.0) {
    double count = 1.0;
    for (int axis = 0; axis < dimension; ++axis) {
      count *= std::floor((component(high, axis) - component(low, axis)) / cell_size_) + 1.0;
    }
    if (count <= most_cells) break;
  }
  for (int axis = 0; axis < dimension; ++axis) {
    n_cells_[axis] = static_cast<std::size_t>((component(high, axis) - component(low, axis)) / cell_size_) + 1;
  }
}

void CellGrid::sort_points(std::span<const Vector> positions) {
  begin_.assign(std::accumulate(n_cells_.begin(), n_cells_.end(), std::size_t{1}, std::multiplies<>()) + 1, 0);
  for (const Vector& position : positions) ++begin_[number_of(cell_at(position)) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  points_.resize(positions.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    points_[next[number_of(cell_at(positions[i]))]++] = static_cast<Index>(i);
  }
}

CellGrid::Cell CellGrid::cell_at(const Vector& place) const {
  Cell cell{};
  for (int axis = 0; axis < dimension; ++axis) {
    const double position = (component(place, axis) - component(origin_, axis)) / cell_size_;
    const double last = static_cast<double>(n_cells_[axis] - 1);
    cell[axis] = static_cast<std::size_t>(std::clamp(position, 0.0, last));
  }
  return cell;
}

std::size_t CellGrid::number_of(const Cell& cell) const {
  std::size_t number = 0;
  for (int axis = dimension - 1; axis >= 0; --axis) number = number * n_cells_[axis] + cell[axis];
  return number;
}

}  // namespace ligament
