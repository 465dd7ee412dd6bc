#include "constitutive/intact_bonds.hpp"

namespace ligament {
namespace {

// Without branches and with columns that do not overlap, so that compilers make vector instructions of it; those are
// chosen when the program starts. Every operation rounds as it does alone, whatever the width.
[[gnu::target_clones("avx512f", "avx2", "default")]] int carry(
    const IntactLimits& limits, std::size_t count, const double* __restrict opening,
    const ShearVector* __restrict slip_increment, const double* __restrict normal_stiffness,
    const double* __restrict shear_stiffness, const double* __restrict area, const BondState* __restrict bond,
    double* __restrict normal_force, ShearVector* __restrict shear_force, std::uint8_t* __restrict left) {
  int n_left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double normal = -normal_stiffness[i] * opening[i];
    const ShearVector shear = shear_force[i] - shear_stiffness[i] * slip_increment[i];
    const bool stays = (static_cast<int>(bond[i] == BondState::bonded) &
                        static_cast<int>(limits.carries(area[i], normal, shear))) != 0;
    normal_force[i] = stays ? normal : normal_force[i];
    shear_force[i] = stays ? shear : shear_force[i];
    left[i] = stays ? 0 : 1;
    n_left += stays ? 0 : 1;
  }
  return n_left;
}

}  // namespace

int carry_intact(const IntactLimits& limits, const ContactBatch& batch, std::size_t begin, std::size_t count,
                 LeftToLaw& left) {
  return carry(limits, count, &batch.opening[begin], &batch.slip_increment[begin], &batch.normal_stiffness[begin],
               &batch.shear_stiffness[begin], &batch.area[begin], &batch.bond[begin], &batch.normal_force[begin],
               &batch.shear_force[begin], left.data());
}

}  // namespace ligament
