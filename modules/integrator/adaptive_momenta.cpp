#include "integrator/adaptive_momenta.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/error.hpp"
#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"

namespace ligament {

void DampingBounds::declare(Parameters& parameters) {
  parameters.number("smallest_damping", smallest, "lower bound of c Δt of relaxation").at_least(0.0).less_than(2.0);
  parameters.number("largest_damping", largest, "upper bound of c Δt of relaxation; above 2 it would overshoot")
      .greater_than(0.0)
      .less_than(2.0);
}

void DampingBounds::check() const {
  if (smallest <= largest) return;
  throw InputError(
      fmt::format("'smallest_damping' is {} in [solver], above 'largest_damping', which is {}", smallest, largest));
}

double adaptive_damping(const std::vector<double>& velocities, const std::vector<double>& momenta,
                        const std::vector<double>& forces, const std::vector<double>& forces_before,
                        const DampingBounds& bounds) {
  const double stiffness =
      block_sum(forces.size(), [&](std::size_t i) { return -velocities[i] * (forces[i] - forces_before[i]); });
  const double mass = product(velocities, momenta);
  const double frequency = stiffness > 0.0 && mass > 0.0 ? std::sqrt(stiffness / mass) : 0.0;
  return std::clamp(2.0 * frequency, bounds.smallest, bounds.largest);
}

void update_momenta(std::vector<double>& momenta, const std::vector<double>& forces, double damping) {
  for (std::size_t i = 0; i < forces.size(); ++i) {
    momenta[i] = ((2.0 - damping) * momenta[i] + 2.0 * forces[i]) / (2.0 + damping);
  }
}

}  // namespace ligament
