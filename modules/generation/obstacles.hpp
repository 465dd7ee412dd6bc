#pragma once

#include <vector>

#include "core/cell_grid.hpp"
#include "generation/tangent_circles.hpp"

namespace ligament {

/// Discs and the four walls of the box [0, size], numbered in this order: what empty circles between them touch.
class Obstacles {
 public:
  /// The grid fits circles about as large as `usual_circle` (m, radius).
  Obstacles(const Field<Vector>& centres, const Field<double>& radii, const Vector& size, double usual_circle);

  [[nodiscard]] std::size_t n_discs() const { return n_discs_; }
  [[nodiscard]] std::size_t size() const { return conditions_.size(); }

  /// What a circle in touch with an obstacle obeys.
  [[nodiscard]] const CircleCondition& operator[](std::size_t i) const { return conditions_[i]; }
  /// An obstacle as a disc, or none if it is a wall.
  [[nodiscard]] const Circle* disc(std::size_t i) const { return std::get_if<Circle>(&conditions_[i]); }

  /// Distance (m) from an obstacle to a circle; < 0 if they overlap.
  [[nodiscard]] double gap(std::size_t i, const Circle& circle) const;

  /// Whether an obstacle overlaps a circle by more than rounding.
  [[nodiscard]] bool is_in_the_way(std::size_t i, const Circle& circle) const {
    return gap(i, circle) < -rounding * circle.radius;
  }

  /// Obstacles nearer to a circle than this (m), in ascending order of cells; walls come last.
  [[nodiscard]] std::vector<std::size_t> within(const Circle& circle, double reach) const;

  /// All obstacles in the way of a circle, in the order of `within`.
  [[nodiscard]] std::vector<std::size_t> in_the_way(const Circle& circle) const {
    return within(circle, -rounding * circle.radius);
  }

 private:
  static constexpr double rounding = 1e-9;

  std::vector<CircleCondition> conditions_;
  std::size_t n_discs_;
  double largest_disc_;
  CellGrid grid_;
};

}  // namespace ligament
