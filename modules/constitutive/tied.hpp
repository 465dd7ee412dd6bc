#pragma once

#include "constitutive/point_law.hpp"
#include "core/parameters.hpp"

namespace ligament {

/// A particle tied to a smooth wall: held along the normal, in tension too, and free to slide. It never breaks.
struct Tied {
  static constexpr std::size_t n_history = 0;
  static std::array<HistoryVariable, n_history> history() { return {}; }

  double friction_coefficient = 0.0;  ///< μ of contacts that form after set-up

  void declare(Parameters& parameters) {
    parameters
        .number("friction_coefficient", friction_coefficient,
                "friction coefficient μ of contacts that form after set-up")
        .at_least(0.0);
  }

  void evaluate(const ContactInput& input, ContactForce& force, std::array<double, n_history>& /*history*/) const {
    force.normal = -input.normal_stiffness * input.opening;
    force.shear = 0.0;
  }

  [[nodiscard]] ContactEnergies energies(const ContactInput& input, const ContactForce& force,
                                         const std::array<double, n_history>& /*history*/) const {
    return {.elastic_normal = 0.5 * force.normal * force.normal / input.normal_stiffness};
  }
};

}  // namespace ligament
