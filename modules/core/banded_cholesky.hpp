#pragma once

#include <cstddef>
#include <vector>

namespace ligament {

/// A symmetric positive definite matrix with entries near its diagonal only, and its factor L Lᵀ. Sums run in one
/// order, so that solutions have the same bits everywhere.
class BandedCholesky {
 public:
  /// All entries zero; those with |row - column| <= bandwidth can be set.
  explicit BandedCholesky(std::size_t size = 0, std::size_t bandwidth = 0)
      : size_(size), bandwidth_(bandwidth), entries_(size * (bandwidth + 1), 0.0) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  /// An entry of the lower triangle, row >= column.
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return entries_[row * (bandwidth_ + 1) + (column + bandwidth_ - row)];
  }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return entries_[row * (bandwidth_ + 1) + (column + bandwidth_ - row)];
  }

  /// Puts the factor in the place of the matrix. Throws std::domain_error if it is not positive definite.
  void factorize();
  /// Puts x with L Lᵀ x = b in the place of b.
  void solve(std::vector<double>& b) const;

 private:
  /// First column of a row with an entry.
  [[nodiscard]] std::size_t first(std::size_t row) const { return row > bandwidth_ ? row - bandwidth_ : 0; }

  std::size_t size_;
  std::size_t bandwidth_;
  std::vector<double> entries_;
};

}  // namespace ligament
