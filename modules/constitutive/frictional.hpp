#pragma once

#include <algorithm>
#include <cmath>

#include "constitutive/point_law.hpp"
#include "core/parameters.hpp"

namespace ligament {

/// A contact without tension that slides at |F_s| = μ F_n (Coulomb).
struct Frictional {
  static constexpr std::size_t n_history = 1;
  static std::array<HistoryVariable, n_history> history() { return {HistoryVariable{"friction_work", "J", 0.0}}; }

  double friction_coefficient = 0.0;  ///< μ

  void declare(Parameters& parameters) {
    parameters.number("friction_coefficient", friction_coefficient, "friction coefficient μ").at_least(0.0).required();
  }

  void evaluate(const ContactInput& input, ContactForce& force, std::array<double, n_history>& history) const {
    force.normal = std::max(0.0, -input.normal_stiffness * input.opening);
    const double limit = friction_coefficient * force.normal;
    const ShearVector trial = force.shear - input.shear_stiffness * input.slip_increment;
    const ShearVector shear = std::abs(trial) <= limit ? trial : std::copysign(limit, trial);
    // What the springs do not take up of the displacement is slip; the mean shear force of the step works on it.
    const ShearVector slip = (shear - trial) / input.shear_stiffness;
    history[0] -= 0.5 * (force.shear + shear) * slip;
    force.shear = shear;
  }

  [[nodiscard]] ContactEnergies energies(const ContactInput& input, const ContactForce& force,
                                         const std::array<double, n_history>& history) const {
    return {.elastic_normal = 0.5 * force.normal * force.normal / input.normal_stiffness,
            .elastic_shear = 0.5 * force.shear * force.shear / input.shear_stiffness,
            .friction = history[0]};
  }
};

}  // namespace ligament
