#pragma once

#include <array>

#include "contact/kinematics.hpp"
#include "contact/law_ranges.hpp"

namespace ligament {

/// One number for every contact of a block.
template <class T>
using BlockColumn = std::array<T, contact_block_size>;

/// ContactMotion of a block of contacts, in columns.
struct BlockMotion {
  VectorColumns<contact_block_size> normal;
  BlockColumn<double> arm_first;
  BlockColumn<double> arm_second;
  BlockColumn<double> share;
  BlockColumn<double> opening;
  BlockColumn<ShearVector> slip_increment;

  void set(std::size_t i, const ContactMotion& motion) {
    normal.set(i, motion.geometry.normal);
    arm_first[i] = motion.geometry.arm_first;
    arm_second[i] = motion.geometry.arm_second;
    share[i] = motion.geometry.share;
    opening[i] = motion.opening;
    slip_increment[i] = motion.slip_increment;
  }
  [[nodiscard]] ContactGeometry geometry(std::size_t i) const {
    return {normal[i], arm_first[i], arm_second[i], share[i]};
  }
};

}  // namespace ligament
