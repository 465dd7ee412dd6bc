#include "integrator/stiffness_mass.hpp"

namespace ligament {

std::vector<double> StiffnessMass::velocities(const std::vector<double>& momenta) {
  // choice: half of the 4 at which a step of 1 s becomes unstable, since contacts that are found or come to touch
  // later on are not in K.
  constexpr double share = 2.0;
  if (!is_factorised_) matrix_.factorise(stiffness_, free_);
  is_factorised_ = true;
  std::vector<double> motion = matrix_.solve(momenta);
  for (double& value : motion) value *= share;
  return motion;
}

}  // namespace ligament
