#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <stdexcept>

#include "core/banded_cholesky.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;

TEST_CASE("a banded matrix is solved like a dense one") {
  support::RandomNumbers numbers(3);
  for (const std::size_t bandwidth : {0, 1, 4, 11}) {
    constexpr std::size_t size = 12;
    BandedCholesky banded(size, bandwidth);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t column = row - std::min(row, bandwidth); column <= row; ++column) {
        const double value = row == column ? 20.0 : numbers.uniform(-1.0, 1.0);
        banded.at(row, column) = value;
        dense(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = value;
        dense(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) = value;
      }
    }
    std::vector<double> b(size);
    Eigen::VectorXd right(size);
    for (std::size_t i = 0; i < size; ++i) b[i] = right[static_cast<Eigen::Index>(i)] = numbers.uniform(-1.0, 1.0);
    banded.factorize();
    banded.solve(b);
    const Eigen::VectorXd wanted = dense.llt().solve(right);
    for (std::size_t i = 0; i < size; ++i) {
      CHECK(b[i] == doctest::Approx(wanted[static_cast<Eigen::Index>(i)]).epsilon(1e-13));
    }
  }
}

TEST_CASE("a matrix that is not positive definite is refused") {
  BandedCholesky matrix(2, 1);
  matrix.at(0, 0) = matrix.at(1, 1) = 1.0;
  matrix.at(1, 0) = 1.0;
  CHECK_THROWS_AS(matrix.factorize(), std::domain_error);
}
