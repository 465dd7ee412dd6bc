#pragma once

#include "core/integrator.hpp"

namespace ligament {

/// No damping: dynamics, and tests of the energy balance.
class NoDamping : public Damping {
 public:
  void declare(Parameters& /*parameters*/) override {}
  DampingCoefficients coefficients(const Model& /*model*/, State& /*state*/) override { return {}; }
};

}  // namespace ligament
