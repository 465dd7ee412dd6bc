#pragma once

#include <algorithm>
#include <cmath>

#include "core/contact_memory.hpp"

/// With which stiffness a contact carries its force, whatever law it has: 0 where it carries none, at most that of its
/// springs.
namespace ligament {

/// Whether the springs are whole: the bond is, or the bodies touch or press.
inline bool is_whole(const ContactTable& contacts, std::size_t row) {
  return contacts.bond[row] == BondState::bonded || contacts.opening[row] <= 0.0;
}

/// Of tension the secant from the reference gap, or, if that is stiffer, from where the contact was before, as it is on
/// elastic unloading.
inline double normal_secant(const ContactTable& contacts, const ContactMemory::Table& before, std::size_t row) {
  const double elastic = contacts.normal_stiffness[row];
  const double force = contacts.normal_force[row];
  if (is_whole(contacts, row)) return elastic;
  if (force == 0.0) return 0.0;
  const double from_gap = -force / contacts.opening[row];
  const double motion = contacts.opening[row] - before.opening[row];
  const double since = motion < 0.0 ? (before.normal_force[row] - force) / motion : 0.0;
  return std::clamp(std::max(from_gap, since), 0.0, elastic);
}

/// The share of the spring's force that is not lost to slip.
inline double shear_secant(const ContactTable& contacts, const ContactMemory::Table& before, std::size_t row) {
  const double elastic = contacts.shear_stiffness[row];
  if (contacts.bond[row] == BondState::bonded) return elastic;
  const ShearVector slip = contacts.shear_displacement[row] - before.shear_displacement[row];
  const double of_spring = std::abs(before.shear_force[row] - elastic * slip);
  const double force = std::abs(contacts.shear_force[row]);
  if (of_spring > 0.0) return elastic * std::min(1.0, force / of_spring);
  return is_whole(contacts, row) || contacts.bond[row] == BondState::softening ? elastic : 0.0;
}

}  // namespace ligament
