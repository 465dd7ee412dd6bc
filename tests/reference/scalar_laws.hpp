#pragma once

#include <cmath>

#include "constitutive/point_law.hpp"

/// Contact laws written out once more, without sharing code with those of the program.
namespace ligament::reference {

inline ContactForce elastic_force(const ContactInput& input, const ContactForce& before) {
  return {-input.normal_stiffness * input.opening, before.shear - input.shear_stiffness * input.slip_increment,
          before.bond};
}

struct SlidingForce {
  ContactForce force;
  double friction_work = 0.0;  ///< of the step (J)
};

/// Coulomb friction: the force sticks at the limit; the mean force of the step works on what the spring does not take.
inline SlidingForce sliding_force(double friction, const ContactInput& input, const ContactForce& before) {
  ContactForce force = before;
  force.normal = input.opening < 0.0 ? -input.normal_stiffness * input.opening : 0.0;
  force.shear = before.shear - input.shear_stiffness * input.slip_increment;
  const double limit = friction * force.normal;
  if (force.shear > limit) force.shear = limit;
  if (force.shear < -limit) force.shear = -limit;
  const double spring_slip = -(force.shear - before.shear) / input.shear_stiffness;
  const double slip = input.slip_increment - spring_slip;
  return {force, -0.5 * (before.shear + force.shear) * slip};
}

}  // namespace ligament::reference
