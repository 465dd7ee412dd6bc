#pragma once

#include "core/vector.hpp"

namespace ligament {

/// A symmetric tensor in the plane: stress (Pa, tension positive) or strain (shear as half the angle).
struct SymmetricTensor {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  SymmetricTensor& operator+=(const SymmetricTensor& b) {
    xx += b.xx;
    yy += b.yy;
    xy += b.xy;
    return *this;
  }
};

/// The symmetric part of a ⊗ b.
constexpr SymmetricTensor symmetric_product(const Vector& a, const Vector& b) {
  return {a.x * b.x, a.y * b.y, 0.5 * (a.x * b.y + a.y * b.x)};
}

constexpr SymmetricTensor operator*(double s, const SymmetricTensor& a) { return {s * a.xx, s * a.yy, s * a.xy}; }

}  // namespace ligament
