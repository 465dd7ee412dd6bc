#pragma once

#include "core/model.hpp"

namespace ligament {

/// Springs of a contact (N/m) and the area A = H t (m2) that carries its strength.
struct ContactStiffness {
  double normal = 0.0;
  double shear = 0.0;
  double area = 0.0;
};

/// Eq. (33) with height H and length L (m), or Eq. (34), times the thickness, as the material asks. Plane strain takes
/// the constrained modulus in (33) and the equivalent constants E/(1-ν²), ν/(1-ν) in (34).
ContactStiffness contact_stiffness(const Material& material, PlaneState plane, double height, double length,
                                   double thickness);

/// The largest Poisson ratio for which Eq. (34) gives a positive shear stiffness is below this.
double poisson_limit_of_hexagonal(PlaneState plane);

}  // namespace ligament
