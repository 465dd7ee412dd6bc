#pragma once

#include "core/integrator.hpp"

namespace ligament {

/// Adaptive dynamic relaxation after Underwood (1983): viscous damping, critical for the frequency that the motion
/// shows, ω² = xᵀSx / xᵀMx, with the local diagonal stiffness S_ii = -Δf_i/Δx_i of the last step.
class DynamicRelaxation : public Damping {
 public:
  void declare(Parameters& parameters) override;
  DampingCoefficients coefficients(const Model& model, State& state) override;

 private:
  double largest_damping_ = 1.9;
};

}  // namespace ligament
