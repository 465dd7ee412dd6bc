#pragma once

#include <array>

#include "contact/kinematics.hpp"
#include "contact/law_ranges.hpp"

namespace ligament {

/// One number for every contact of a block.
template <class T>
using BlockColumn = std::array<T, contact_block_size>;

/// One vector for every contact of a block, component beside component as in a Field<Vector>. Numbers, not vectors:
/// compilers make vector instructions of loops over these alone.
class BlockVectors {
 public:
  [[nodiscard]] Vector operator[](std::size_t i) const {
    Vector vector;
    for (int axis = 0; axis < dimension; ++axis) set_component(vector, axis, components_[dimension * i + axis]);
    return vector;
  }
  void set(std::size_t i, const Vector& vector) {
    for (int axis = 0; axis < dimension; ++axis) components_[dimension * i + axis] = component(vector, axis);
  }

 private:
  std::array<double, dimension * contact_block_size> components_;
};

/// ContactMotion of a block of contacts, in columns.
struct BlockMotion {
  BlockVectors normal;
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

/// What contacts remember of the motions of a block: openings, and slips on those before.
void keep_motion(std::size_t size, const BlockMotion& motion, double* opening, ShearVector* shear_displacement);

}  // namespace ligament
