#pragma once

#include <memory>
#include <vector>

#include "core/stiffness_sum.hpp"

namespace ligament {

/// A stiffness matrix, factorised as L D Lᵀ. Prescribed freedoms do not move. One thread does it all, so that its bits
/// depend on the values alone.
class SparseStiffness {
 public:
  SparseStiffness();
  ~SparseStiffness();

  /// Takes K = Σ k b bᵀ + the elements; `free` is 1 for free freedoms. Which freedoms a spring joins is expected to
  /// stay the same from call to call, or to change seldom. Freedoms that have lost their stiffness keep a trace of that
  /// of the diagonal.
  void factorise(const StiffnessSum& stiffness, const std::vector<double>& free);
  /// K⁻¹ f for the free freedoms.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& forces) const;
  /// Of K; 1 for prescribed freedoms.
  [[nodiscard]] const std::vector<double>& diagonal() const { return diagonal_; }

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
  std::vector<double> diagonal_;
};

}  // namespace ligament
