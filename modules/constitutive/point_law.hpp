#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "core/constitutive_law.hpp"

namespace ligament {

/// What a law is told of one contact in a step.
struct ContactInput {
  double opening = 0.0;              ///< u_n(n) (m), > 0 apart
  ShearVector slip_increment = 0.0;  ///< Δu_s from n-1 to n (m)
  double normal_stiffness = 0.0;     ///< k_n (N/m)
  double shear_stiffness = 0.0;      ///< k_s (N/m)
  double area = 0.0;                 ///< A (m2)
};

/// What the contact carries from step to step; a law moves it from n-1 to n.
struct ContactForce {
  double normal = 0.0;      ///< F_n (N), > 0 in compression
  ShearVector shear = 0.0;  ///< F_s (N)
  BondState bond = BondState::unbonded;
};

/// A law as its author writes it: parameters as members and pure functions at a point. BatchLaw makes the rest.
template <class Law>
concept PointLaw = requires(Law law, const Law constant, Parameters& parameters, const ContactInput& input,
                            ContactForce& force, std::array<double, Law::n_history>& history) {
  { Law::history() } -> std::convertible_to<std::array<HistoryVariable, Law::n_history>>;
  {law.declare(parameters)};
  {constant.evaluate(input, force, history)};
  { constant.energies(input, force, history) } -> std::convertible_to<ContactEnergies>;
  { constant.friction_coefficient } -> std::convertible_to<double>;
};

}  // namespace ligament
