#include "core/banded_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ligament {

void BandedCholesky::factorize() {
  for (std::size_t row = 0; row < size_; ++row) {
    for (std::size_t column = first(row); column <= row; ++column) {
      double sum = at(row, column);
      for (std::size_t k = std::max(first(row), first(column)); k < column; ++k) sum -= at(row, k) * at(column, k);
      if (column < row) {
        at(row, column) = sum / at(column, column);
      } else if (sum > 0.0) {
        at(row, row) = std::sqrt(sum);
      } else {
        throw std::domain_error("the matrix is not positive definite");
      }
    }
  }
}

void BandedCholesky::solve(std::vector<double>& b) const {
  for (std::size_t row = 0; row < size_; ++row) {
    for (std::size_t k = first(row); k < row; ++k) b[row] -= at(row, k) * b[k];
    b[row] /= at(row, row);
  }
  for (std::size_t row = size_; row-- > 0;) {
    b[row] /= at(row, row);
    for (std::size_t k = first(row); k < row; ++k) b[k] -= at(row, k) * b[row];
  }
}

}  // namespace ligament
