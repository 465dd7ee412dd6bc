#include "constitutive/intact_bonds.hpp"

namespace ligament {
namespace {

/// What the bonds of a chunk would carry if they were intact (N).
struct TrialForces {
  std::array<double, intact_chunk> normal;
  std::array<ShearVector, intact_chunk> shear;
};

bool is_bonded(BondState bond) { return bond == BondState::bonded; }

// Without branches, with columns that do not overlap and numbers of one width, so that compilers make vector
// instructions of it; those are chosen when the program starts. Every operation rounds as it does alone, whatever the
// width. Returns how many intact bonds would not carry their forces.
[[gnu::target_clones("avx512f", "avx2", "default")]] std::int64_t try_forces(
    const IntactLimits& limits, std::size_t count, const double* __restrict opening,
    const ShearVector* __restrict slip_increment, const double* __restrict normal_stiffness,
    const double* __restrict shear_stiffness, const double* __restrict area, const ShearVector* __restrict shear_force,
    TrialForces& __restrict trial) {
  std::int64_t n_too_large = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double normal = -normal_stiffness[i] * opening[i];
    const ShearVector shear = shear_force[i] - shear_stiffness[i] * slip_increment[i];
    trial.normal[i] = normal;
    trial.shear[i] = shear;
    n_too_large += limits.carries(area[i], normal, shear) ? 0 : 1;
  }
  return n_too_large;
}

}  // namespace

int carry_intact(const IntactLimits& limits, const ContactBatch& batch, std::size_t begin, std::size_t count,
                 LeftToLaw& left) {
  TrialForces trial;
  const std::int64_t n_too_large =
      try_forces(limits, count, &batch.opening[begin], &batch.slip_increment[begin], &batch.normal_stiffness[begin],
                 &batch.shear_stiffness[begin], &batch.area[begin], &batch.shear_force[begin], trial);
  const auto bonds = batch.bond.subspan(begin, count);
  if (n_too_large == 0 && std::all_of(bonds.begin(), bonds.end(), is_bonded)) {
    std::copy_n(trial.normal.begin(), count, batch.normal_force.begin() + begin);
    std::copy_n(trial.shear.begin(), count, batch.shear_force.begin() + begin);
    return 0;
  }
  int n_left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool stays = is_bonded(bonds[i]) && limits.carries(batch.area[begin + i], trial.normal[i], trial.shear[i]);
    left[i] = stays ? 0 : 1;
    if (stays) {
      batch.normal_force[begin + i] = trial.normal[i];
      batch.shear_force[begin + i] = trial.shear[i];
    } else {
      ++n_left;
    }
  }
  return n_left;
}

}  // namespace ligament
