#pragma once

#include <algorithm>
#include <cmath>

#include "core/contact_memory.hpp"

/// With which stiffness a contact carries its force, whatever law it has: 0 where it carries none, at most that of its
/// springs.
namespace ligament {

/// A contact as far as its secants go.
struct ContactValues {
  double normal_stiffness = 0.0;
  double shear_stiffness = 0.0;
  BondState bond = BondState::unbonded;
  double opening = 0.0;
  ShearVector shear_displacement = 0.0;
  double normal_force = 0.0;
  ShearVector shear_force = 0.0;

  /// Whether the contact slides on a law that bears no shear, as that of a tied wall does.
  [[nodiscard]] bool is_smooth() const { return shear_force == 0.0 && shear_displacement != 0.0; }
  /// Whether the springs are whole: the bond is, or the bodies touch or press.
  [[nodiscard]] bool is_whole() const { return bond == BondState::bonded || opening <= 0.0; }
};

inline ContactValues values_of(const ContactTable& contacts, std::size_t row) {
  return {contacts.normal_stiffness[row], contacts.shear_stiffness[row],    contacts.bond[row],
          contacts.opening[row],          contacts.shear_displacement[row], contacts.normal_force[row],
          contacts.shear_force[row]};
}

/// Of tension the secant from the reference gap, or, if that is stiffer, from where the contact was before, as it is on
/// elastic unloading.
inline double normal_secant(const ContactValues& now, const ContactMemory::Table& before, std::size_t row) {
  if (now.is_whole()) return now.normal_stiffness;
  if (now.normal_force == 0.0) return 0.0;
  const double from_gap = -now.normal_force / now.opening;
  const double motion = now.opening - before.opening[row];
  const double since = motion < 0.0 ? (before.normal_force[row] - now.normal_force) / motion : 0.0;
  return std::clamp(std::max(from_gap, since), 0.0, now.normal_stiffness);
}

/// The share of the spring's force that is not lost to slip.
inline double shear_secant(const ContactValues& now, const ContactMemory::Table& before, std::size_t row) {
  const double elastic = now.shear_stiffness;
  if (now.bond == BondState::bonded) return now.is_smooth() ? 0.0 : elastic;
  const ShearVector slip = now.shear_displacement - before.shear_displacement[row];
  const double of_spring = std::abs(before.shear_force[row] - elastic * slip);
  if (of_spring > 0.0) return elastic * std::min(1.0, std::abs(now.shear_force) / of_spring);
  return now.is_whole() || now.bond == BondState::softening ? elastic : 0.0;
}

}  // namespace ligament
