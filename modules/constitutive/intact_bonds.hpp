#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/constitutive_law.hpp"

namespace ligament {

/// What undamaged bonds carry: tension up to σ_t A, shear up to C A + μ F_n with F_n > 0. In tension there is no
/// friction term (Mohr-Coulomb with a tension cut-off).
struct IntactLimits {
  double tensile_strength = 0.0;      ///< σ_t (Pa)
  double cohesion = 0.0;              ///< C (Pa)
  double friction_coefficient = 0.0;  ///< μ

  /// Whether a bond of this area carries these forces (N). Without branches.
  [[nodiscard]] bool carries(double area, double normal, ShearVector shear) const {
    const double shear_limit = cohesion * area + friction_coefficient * std::max(0.0, normal);
    return (static_cast<int>(normal >= -tensile_strength * area) & static_cast<int>(std::abs(shear) <= shear_limit)) !=
           0;
  }
};

/// So many contacts are looked at together.
inline constexpr std::size_t intact_chunk = 128;

/// Which of them are left to the law: 1 where a bond is damaged or no longer carries its trial forces.
using LeftToLaw = std::array<std::uint8_t, intact_chunk>;

/// Forces of the bonds in [begin, begin + count), count up to intact_chunk, that are intact and stay so, Eqs (19)-(20),
/// to the same bits as the law alone; nearly all of them are. Returns how many others there are, which keep their
/// forces. As many at a time as the processor can take.
int carry_intact(const IntactLimits& limits, const ContactBatch& batch, std::size_t begin, std::size_t count,
                 LeftToLaw& left);

}  // namespace ligament
