#pragma once

#include <memory>
#include <span>
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
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& forces) const { return back(half(forces)); }

  /// z = D^-½ L⁻¹ f, half of a solution: f·K⁻¹ g = z(f)·z(g).
  [[nodiscard]] std::vector<double> half(const std::vector<double>& forces) const;
  /// The other half: K⁻¹ f from z.
  [[nodiscard]] std::vector<double> back(std::vector<double> half) const;

  /// The same half for forces on few freedoms: what is not zero in it, places ascending.
  struct SparseHalf {
    std::vector<Index> places;
    std::vector<double> values;
  };
  [[nodiscard]] SparseHalf half(std::span<const SpringTerm> forces) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace ligament
