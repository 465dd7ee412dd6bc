#include "integrator/spring_flexibility.hpp"

#include <algorithm>
#include <array>

namespace ligament {
namespace {

/// So many springs are multiplied with all others at a time.
constexpr std::size_t n_lanes = 8;
using Lanes = std::array<double, n_lanes>;

/// Terms at which the dense ones are zero add nothing, so that it does not matter which of two springs is the sparse
/// one.
[[gnu::target_clones("avx512f", "avx2", "default")]] void find_products(std::size_t size, const Index* places,
                                                                        const double* values, const Lanes* dense,
                                                                        Lanes& products) {
  Lanes sums{};
  for (std::size_t k = 0; k < size; ++k) {
    const Lanes& row = dense[places[k]];
    for (std::size_t lane = 0; lane < n_lanes; ++lane) sums[lane] += values[k] * row[lane];
  }
  products = sums;
}

}  // namespace

void SpringFlexibility::factorise(StiffnessSum sum, std::vector<double> free) {
  sum_.emplace(std::move(sum));
  free_ = std::move(free);
  matrix_.factorise(*sum_, free_);
  numbers_.clear();
  halves_.clear();
  products_.clear();
}

double SpringFlexibility::stretch(std::size_t spring, const std::vector<double>& motion) const {
  double sum = 0.0;
  for (const SpringTerm& term : sum_->spring(spring).terms) sum += term.factor * motion[term.freedom];
  return sum;
}

void SpringFlexibility::learn(const std::vector<std::size_t>& springs) {
  const std::size_t n_known = halves_.size();
  for (const std::size_t spring : springs) {
    const auto [place, is_new] = numbers_.try_emplace(spring, halves_.size());
    if (!is_new) continue;
    std::vector<SpringTerm> terms;
    for (const SpringTerm& term : sum_->spring(spring).terms) {
      if (free_[term.freedom] != 0.0) terms.push_back(term);
    }
    halves_.push_back(matrix_.half(terms));
  }
  if (halves_.size() == n_known) return;
  std::vector<Lanes> dense(free_.size());
  for (std::size_t begin = n_known; begin < halves_.size(); begin += n_lanes) {
    const std::size_t count = std::min(n_lanes, halves_.size() - begin);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const SparseStiffness::SparseHalf& half = halves_[begin + lane];
      for (std::size_t k = 0; k < half.places.size(); ++k) dense[half.places[k]][lane] = half.values[k];
      products_.emplace_back();
    }
    for (std::size_t other = 0; other < begin + count; ++other) {
      const SparseStiffness::SparseHalf& sparse = halves_[other];
      Lanes all;
      find_products(sparse.places.size(), sparse.places.data(), sparse.values.data(), dense.data(), all);
      for (std::size_t lane = 0; lane < count; ++lane) {
        if (other <= begin + lane) products_[begin + lane].push_back(all[lane]);
      }
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
      for (const Index row : halves_[begin + lane].places) dense[row][lane] = 0.0;
    }
  }
}

std::vector<double> SpringFlexibility::between(const std::vector<std::size_t>& springs) {
  std::vector<std::size_t> numbers;
  learn(springs);
  for (const std::size_t spring : springs) numbers.push_back(numbers_.at(spring));
  std::vector<double> all;
  all.reserve(springs.size() * springs.size());
  for (const std::size_t i : numbers) {
    for (const std::size_t j : numbers) all.push_back(products_[std::max(i, j)][std::min(i, j)]);
  }
  return all;
}

double SpringFlexibility::response(std::size_t spring, const std::vector<double>& half) const {
  const SparseStiffness::SparseHalf& own = halves_[numbers_.at(spring)];
  double sum = 0.0;
  for (std::size_t k = 0; k < own.places.size(); ++k) sum += own.values[k] * half[own.places[k]];
  return sum;
}

void SpringFlexibility::add_half(std::size_t spring, double factor, std::vector<double>& half) const {
  const SparseStiffness::SparseHalf& own = halves_[numbers_.at(spring)];
  for (std::size_t k = 0; k < own.places.size(); ++k) half[own.places[k]] += factor * own.values[k];
}

}  // namespace ligament
