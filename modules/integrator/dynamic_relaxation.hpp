#pragma once

#include "core/integrator.hpp"

namespace ligament {

/// Adaptive dynamic relaxation after Underwood (1983): viscous damping c = 2 ζ ω for the frequency that the motion
/// shows, ω² = xᵀSx / xᵀMx, with the motion x = Δx of the last step and its local diagonal stiffness S_ii = -Δf_i/Δx_i.
class DynamicRelaxation : public Damping {
 public:
  void declare(Parameters& parameters) override;
  DampingCoefficients coefficients(const Model& model, State& state) override;

 private:
  /// ζ. choice: a little below critical, since faster motions than the slowest one raise the frequency found, and a
  /// slow motion that is damped too much creeps: saves a quarter of the steps of the tensioned columns.
  double damping_ratio_ = 0.9;
  double largest_damping_ = 1.9;
};

}  // namespace ligament
