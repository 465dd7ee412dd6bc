#pragma once

#include <cmath>

#include "constitutive/point_law.hpp"

namespace ligament::test {

/// One bond of 1 mm x 0.1 m with the springs of the paper's Table 4, led along a path; the work of its forces is summed
/// up by the trapezoidal rule.
template <PointLaw Law>
struct DrivenBond {
  static constexpr double area = 1e-4;
  static constexpr double k_n = 7.8e8;
  static constexpr double k_s = 2.9e8;

  Law law;
  ContactForce force{0.0, 0.0, BondState::bonded};
  std::array<double, Law::n_history> history{};
  double opening = 0.0;
  double work = 0.0;  ///< done on the bond (J)

  explicit DrivenBond(Law law_of_bond) : law(std::move(law_of_bond)) {}

  [[nodiscard]] ContactInput input(double slip_increment = 0.0) const {
    return {opening, slip_increment, k_n, k_s, area};
  }
  void step(double new_opening, double slip_increment) {
    const ContactForce before = force;
    const double opened = new_opening - opening;
    opening = new_opening;
    law.evaluate(input(slip_increment), force, history);
    work -= 0.5 * ((before.normal + force.normal) * opened + (before.shear + force.shear) * slip_increment);
  }
  void pull_to(double new_opening, int n_steps = 1) {
    const double from = opening;
    for (int i = 1; i <= n_steps; ++i) step(from + (new_opening - from) * i / n_steps, 0.0);
  }
  void slip_by(double slip, int n_steps = 1) {
    for (int i = 0; i < n_steps; ++i) step(opening, slip / n_steps);
  }
  [[nodiscard]] ContactEnergies energies() const { return law.energies(input(), force, history); }
  /// Energy that the trapezoidal rule did not see (J).
  [[nodiscard]] double defect() const { return energies().stored() + energies().spent() - work; }
};

/// The paper's Table 4.
template <class Law>
Law concrete() {
  Law law;
  law.tensile_strength = 1.8e6;
  law.cohesion = 6.5e6;
  law.friction_coefficient = 0.2;
  law.fracture_energy_tension = 10.0;
  law.fracture_energy_shear = 500.0;
  return law;
}

}  // namespace ligament::test
