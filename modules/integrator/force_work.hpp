#pragma once

#include <vector>

#include "core/block_sum.hpp"

namespace ligament {

/// What forces do on a motion of all freedoms (J), or the rates at which they do it.
struct ForceWork {
  double of_all = 0.0;    ///< of resultants on all freedoms
  double of_free = 0.0;   ///< on free ones
  double of_loads = 0.0;  ///< of applied loads

  ForceWork& operator+=(const ForceWork& b) {
    of_all += b.of_all;
    of_free += b.of_free;
    of_loads += b.of_loads;
    return *this;
  }
  friend ForceWork operator+(ForceWork a, const ForceWork& b) { return a += b; }
  friend ForceWork operator*(double s, const ForceWork& a) { return {s * a.of_all, s * a.of_free, s * a.of_loads}; }
  friend ForceWork operator-(const ForceWork& a, const ForceWork& b) { return a + (-1.0) * b; }
  /// Of what moves prescribed freedoms, against the resultants on them.
  [[nodiscard]] double of_prescribed() const { return of_free - of_all; }
  /// Of internal forces, which contacts and elements store or spend.
  [[nodiscard]] double of_internal() const { return of_all - of_loads; }
};

/// `free` is 1 for free freedoms, `forces` are the resultants, `loads` what applied loads have in them.
inline ForceWork work_of(const std::vector<double>& free, const std::vector<double>& motion,
                         const std::vector<double>& forces, const std::vector<double>& loads) {
  return block_sum(motion.size(), [&](std::size_t i) {
    const double all = forces[i] * motion[i];
    return ForceWork{all, free[i] * all, free[i] * loads[i] * motion[i]};
  });
}

}  // namespace ligament
