#pragma once

#include "integrator/relaxation_mass.hpp"
#include "integrator/sparse_stiffness.hpp"

namespace ligament {

/// The elastic stiffness itself as mass, M = K/a: what has not been damaged comes to rest within a few steps, whatever
/// its size and shape, and what is left unbalanced is small where the displacement still lacks little.
class StiffnessMass : public RelaxationMass {
 public:
  /// `free` is 1 for free freedoms.
  StiffnessMass(StiffnessSum stiffness, std::vector<double> free)
      : stiffness_(std::move(stiffness)), free_(std::move(free)) {}

  [[nodiscard]] std::vector<double> velocities(const std::vector<double>& momenta) override;

 private:
  StiffnessSum stiffness_;
  std::vector<double> free_;
  SparseStiffness matrix_;
  bool is_factorised_ = false;  ///< when it is first asked for
};

}  // namespace ligament
