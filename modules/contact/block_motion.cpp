#include "contact/block_motion.hpp"

namespace ligament {

[[gnu::target_clones("avx512f", "avx2", "default")]] void keep_motion(std::size_t size,
                                                                      const BlockMotion& __restrict motion,
                                                                      double* __restrict opening,
                                                                      ShearVector* __restrict shear_displacement) {
  for (std::size_t i = 0; i < size; ++i) {
    opening[i] = motion.opening[i];
    shear_displacement[i] += motion.slip_increment[i];
  }
}

}  // namespace ligament
