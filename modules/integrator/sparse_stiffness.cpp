#include "integrator/sparse_stiffness.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <map>

namespace ligament {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Calls visit(row, column, value) for the lower triangle of all springs and elements, always in the same order.
template <class Visit>
void visit_entries(const StiffnessSum& stiffness, const std::vector<double>& free, Visit&& visit) {
  const auto add = [&](Index a, Index b, double value) {
    if (a >= b && free[a] != 0.0 && free[b] != 0.0) visit(a, b, value);
  };
  for (std::size_t i = 0; i < stiffness.n_springs(); ++i) {
    const auto [terms, k] = stiffness.spring(i);
    for (const SpringTerm& a : terms) {
      for (const SpringTerm& b : terms) add(a.freedom, b.freedom, k * a.factor * b.factor);
    }
  }
  for (const auto& [freedoms, matrix] : stiffness.elements()) {
    for (std::size_t row = 0; row < 8; ++row) {
      for (std::size_t column = 0; column < 8; ++column) {
        add(freedoms[row], freedoms[column], (*matrix)[8 * row + column]);
      }
    }
  }
}

/// x ← L⁻ᵀ x, the diagonal of L being 1. Sums of four: one alone would wait for itself at every term.
void solve_transposed(const Matrix& lower, std::vector<double>& x) {
  const int* begin = lower.outerIndexPtr();
  const int* rows = lower.innerIndexPtr();
  const double* values = lower.valuePtr();
  for (auto column = static_cast<int>(x.size()) - 1; column >= 0; --column) {
    std::array<double, 4> sums{};
    int k = begin[column];
    for (; k + 4 <= begin[column + 1]; k += 4) {
      for (int i = 0; i < 4; ++i) sums[i] += values[k + i] * x[rows[k + i]];
    }
    for (; k < begin[column + 1]; ++k) sums[0] += values[k] * x[rows[k]];
    x[column] -= (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
}

}  // namespace

struct SparseStiffness::Factors {
  Matrix matrix;
  std::vector<std::size_t> places;  ///< in the values of the matrix, of all entries as they are visited
  std::vector<Index> joined;        ///< freedoms of all springs, one after the other
  Eigen::SimplicialLDLT<Matrix> decomposition;
  Eigen::VectorXd scale;  ///< D^-½
  // Scratch.
  std::vector<double> work;
  std::vector<char> is_seen;

  [[nodiscard]] bool fits(const StiffnessSum& stiffness) const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < stiffness.n_springs(); ++i) {
      for (const SpringTerm& term : stiffness.spring(i).terms) {
        if (next == joined.size() || joined[next++] != term.freedom) return false;
      }
    }
    return next == joined.size() && matrix.rows() > 0;
  }

  void analyse(const StiffnessSum& stiffness, const std::vector<double>& free) {
    joined.clear();
    for (std::size_t i = 0; i < stiffness.n_springs(); ++i) {
      for (const SpringTerm& term : stiffness.spring(i).terms) joined.push_back(term.freedom);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < free.size(); ++i) entries.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.0);
    visit_entries(stiffness, free, [&](Index a, Index b, double) { entries.emplace_back(a, b, 1.0); });
    matrix.resize(static_cast<Eigen::Index>(free.size()), static_cast<Eigen::Index>(free.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    places.clear();
    visit_entries(stiffness, free, [&](Index a, Index b, double) {
      places.push_back(static_cast<std::size_t>(&matrix.coeffRef(a, b) - matrix.valuePtr()));
    });
    decomposition.analyzePattern(matrix);
  }
};

SparseStiffness::SparseStiffness() : factors_(std::make_unique<Factors>()) {}
SparseStiffness::~SparseStiffness() = default;

void SparseStiffness::factorise(const StiffnessSum& stiffness, const std::vector<double>& free) {
  if (!factors_->fits(stiffness)) factors_->analyse(stiffness, free);
  Matrix& matrix = factors_->matrix;
  double* values = matrix.valuePtr();
  std::fill_n(values, matrix.nonZeros(), 0.0);
  std::size_t next = 0;
  visit_entries(stiffness, free, [&](Index, Index, double value) { values[factors_->places[next++]] += value; });
  double largest = 0.0;
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) largest = std::max(largest, matrix.coeff(i, i));
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
    double& value = matrix.coeffRef(i, i);
    value = free[static_cast<std::size_t>(i)] != 0.0 ? value + 1e-10 * largest : 1.0;
  }
  factors_->decomposition.factorize(matrix);
  factors_->scale = factors_->decomposition.vectorD().cwiseSqrt().cwiseInverse();
}

std::vector<double> SparseStiffness::half(const std::vector<double>& forces) const {
  const Eigen::Map<const Eigen::VectorXd> right(forces.data(), static_cast<Eigen::Index>(forces.size()));
  std::vector<double> half(forces.size());
  Eigen::Map<Eigen::VectorXd> left(half.data(), right.size());
  left = factors_->decomposition.permutationP() * right;
  factors_->decomposition.matrixL().solveInPlace(left);
  left = left.cwiseProduct(factors_->scale);
  return half;
}

std::vector<double> SparseStiffness::back(std::vector<double> half) const {
  Eigen::Map<Eigen::VectorXd> right(half.data(), static_cast<Eigen::Index>(half.size()));
  right = right.cwiseProduct(factors_->scale);
  solve_transposed(factors_->decomposition.matrixL().nestedExpression(), half);
  std::vector<double> motion(half.size());
  Eigen::Map<Eigen::VectorXd>(motion.data(), right.size()) = factors_->decomposition.permutationPinv() * right;
  return motion;
}

SparseStiffness::SparseHalf SparseStiffness::half(std::span<const SpringTerm> forces) const {
  // Elimination hands on what reaches a freedom to the first one below it in its column of L, and so on.
  const Matrix& lower = factors_->decomposition.matrixL().nestedExpression();
  const auto& order = factors_->decomposition.permutationP().indices();
  std::map<int, double> start;
  for (const SpringTerm& term : forces) start[order[term.freedom]] += term.factor;
  SparseHalf half;
  std::vector<double>& work = factors_->work;
  std::vector<char>& is_seen = factors_->is_seen;
  work.resize(static_cast<std::size_t>(lower.cols()), 0.0);
  is_seen.resize(work.size(), 0);
  for (const auto& [place, value] : start) {
    work[static_cast<std::size_t>(place)] = value;
    for (int i = place; is_seen[static_cast<std::size_t>(i)] == 0;) {
      is_seen[static_cast<std::size_t>(i)] = 1;
      half.places.push_back(static_cast<Index>(i));
      const int first = lower.outerIndexPtr()[i];
      if (first == lower.outerIndexPtr()[i + 1]) break;
      i = lower.innerIndexPtr()[first];
    }
  }
  std::sort(half.places.begin(), half.places.end());
  for (const Index place : half.places) {
    const double value = work[static_cast<std::size_t>(place)];
    for (int k = lower.outerIndexPtr()[place]; k < lower.outerIndexPtr()[place + 1]; ++k) {
      work[static_cast<std::size_t>(lower.innerIndexPtr()[k])] -= lower.valuePtr()[k] * value;
    }
    half.values.push_back(value * factors_->scale[place]);
    work[static_cast<std::size_t>(place)] = 0.0;
    is_seen[static_cast<std::size_t>(place)] = 0;
  }
  return half;
}

}  // namespace ligament
