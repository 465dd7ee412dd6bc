#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/stiffness_sum.hpp"
#include "integrator/sparse_stiffness.hpp"

namespace ligament {

/// A factorised stiffness K, and how springs in it give way to the pulls of each other, b_iᵀ K⁻¹ b_j. What it takes for
/// that of a spring is calculated when it is first asked for, and kept; its bits do not depend on the order of asking.
class SpringFlexibility {
 public:
  /// Takes K; `free` is 1 for free freedoms.
  void factorise(StiffnessSum sum, std::vector<double> free);

  [[nodiscard]] bool is_empty() const { return !sum_.has_value(); }
  [[nodiscard]] const StiffnessSum& sum() const { return *sum_; }
  [[nodiscard]] const SparseStiffness& matrix() const { return matrix_; }

  /// b_iᵀ u.
  [[nodiscard]] double stretch(std::size_t spring, const std::vector<double>& motion) const;
  /// b_iᵀ K⁻¹ b_j of all springs asked for, row by row (m/N).
  [[nodiscard]] std::vector<double> between(const std::vector<std::size_t>& springs);
  /// b_iᵀ K⁻¹ f, of f the half; of springs that have been asked for.
  [[nodiscard]] double response(std::size_t spring, const std::vector<double>& half) const;
  /// Adds a factor times the half of b_i, of such a spring.
  void add_half(std::size_t spring, double factor, std::vector<double>& half) const;

 private:
  /// Makes springs known.
  void learn(const std::vector<std::size_t>& springs);

  std::optional<StiffnessSum> sum_;
  std::vector<double> free_;
  SparseStiffness matrix_;
  std::map<std::size_t, std::size_t> numbers_;
  std::vector<SparseStiffness::SparseHalf> halves_;
  std::vector<std::vector<double>> products_;  ///< of every known spring with those before it and itself
};

}  // namespace ligament
