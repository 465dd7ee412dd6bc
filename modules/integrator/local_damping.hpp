#pragma once

#include "core/integrator.hpp"
#include "core/parameters.hpp"

namespace ligament {

/// Cundall's local damping: a force of α times the resultant against the mean velocity of every freedom in the step.
/// Masses close to the bound leave the fastest motions undamped: a safety of 1.3 brings bodies to rest much sooner.
class LocalDamping : public Damping {
 public:
  void declare(Parameters& parameters) override {
    parameters.number("local_damping", alpha_, "local damping α, share of the resultant force that opposes the motion")
        .at_least(0.0)
        .less_than(1.0);
  }
  DampingCoefficients coefficients(const Model& /*model*/, State& /*state*/) override { return {.local = alpha_}; }

 private:
  double alpha_ = 0.7;
};

}  // namespace ligament
