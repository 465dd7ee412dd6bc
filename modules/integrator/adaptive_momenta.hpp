#pragma once

#include <vector>

namespace ligament {

/// Bounds of the damping c Δt.
struct DampingBounds {
  /// Without a floor single assemblies fail to settle.
  double smallest = 0.02;
  double largest = 1.9;

  void declare(class Parameters& parameters);
  /// Throws InputError if they leave no room.
  void check() const;
};

/// c = 2 ω within bounds, with the frequency that the motion v shows, ω² = -v·Δf / v·p.
double adaptive_damping(const std::vector<double>& velocities, const std::vector<double>& momenta,
                        const std::vector<double>& forces, const std::vector<double>& forces_before,
                        const DampingBounds& bounds);

/// p(n+½) = [(2 - c) p(n-½) + 2 f] / (2 + c), for steps of 1 s.
void update_momenta(std::vector<double>& momenta, const std::vector<double>& forces, double damping);

}  // namespace ligament
