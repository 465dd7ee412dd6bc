#pragma once

#include <vector>

namespace ligament {

/// A symmetric mass M for relaxation in steps of 1 s of pseudo-time. Columns are numbered as in FreedomNumbers;
/// prescribed freedoms are zero in them.
class RelaxationMass {
 public:
  virtual ~RelaxationMass() = default;

  /// v = M⁻¹ p.
  [[nodiscard]] virtual std::vector<double> velocities(const std::vector<double>& momenta) = 0;
};

}  // namespace ligament
