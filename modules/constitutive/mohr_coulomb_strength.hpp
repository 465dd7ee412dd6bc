#pragma once

#include "constitutive/frictional.hpp"
#include "constitutive/intact_bonds.hpp"
#include "constitutive/point_law.hpp"
#include "core/parameters.hpp"

namespace ligament {

/// The strength of an undamaged bond, as its laws have it.
struct MohrCoulombStrength {
  double tensile_strength = 0.0;      ///< σ_t (Pa)
  double cohesion = 0.0;              ///< C (Pa)
  double friction_coefficient = 0.0;  ///< μ

  void declare(Parameters& parameters) {
    parameters.quantity("tensile_strength", tensile_strength, "Pa", "tensile strength σ_t of bonds")
        .required()
        .greater_than(0.0);
    parameters.quantity("cohesion", cohesion, "Pa", "cohesion C: shear strength of bonds without pressure")
        .required()
        .greater_than(0.0);
    parameters.number("friction_coefficient", friction_coefficient, "friction coefficient μ").required().at_least(0.0);
  }

  [[nodiscard]] IntactLimits intact_limits() const { return {tensile_strength, cohesion, friction_coefficient}; }

  /// The step of a broken bond: contact with friction.
  void slide(const ContactInput& input, ContactForce& force, double& friction_work) const {
    std::array<double, Frictional::n_history> history{friction_work};
    Frictional{friction_coefficient}.evaluate(input, force, history);
    friction_work = history[0];
  }
};

}  // namespace ligament
