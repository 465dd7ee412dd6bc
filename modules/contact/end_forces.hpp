#pragma once

#include <array>

#include "contact/block_motion.hpp"

namespace ligament {

/// F_C = F_n n + F_s t on the second body, Eq. (24).
struct ContactPointForce {
  Vector force;             ///< F_C (N)
  ShearVector shear = 0.0;  ///< F_s (N)
};

inline ContactPointForce contact_point_force(const Vector& normal, double normal_force, ShearVector shear_force) {
  return {normal_force * normal + shear_force * tangent(normal), shear_force};
}

/// What a contact does to a body at one of its ends; nodes feel no moment.
struct EndForce {
  Vector force;         ///< (N)
  Moment moment = 0.0;  ///< (N m)

  EndForce& operator+=(const EndForce& b) {
    force += b.force;
    moment += b.moment;
    return *this;
  }
};

/// On a particle that is the first body.
inline EndForce force_on_first(const ContactGeometry& geometry, const ContactPointForce& contact) {
  return {-contact.force, -(geometry.arm_first * contact.shear)};
}

/// On a particle that is the second body.
inline EndForce force_on_second(const ContactGeometry& geometry, const ContactPointForce& contact) {
  return {contact.force, -(geometry.arm_second * contact.shear)};
}

/// What a block of contacts does to the bodies at each of its ends, in columns.
template <std::size_t n_ends>
struct BlockEndForces {
  std::array<BlockVectors, n_ends> force;
  std::array<BlockColumn<Moment>, n_ends> moment;

  void set(std::size_t i, const std::array<EndForce, n_ends>& ends) {
    for (std::size_t end = 0; end < n_ends; ++end) {
      force[end].set(i, ends[end].force);
      moment[end][i] = ends[end].moment;
    }
  }
  [[nodiscard]] EndForce at(std::size_t end, std::size_t i) const { return {force[end][i], moment[end][i]}; }
};

}  // namespace ligament
