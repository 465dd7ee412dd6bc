#include "contact/contact_stiffness.hpp"

#include <cmath>

namespace ligament {
namespace {

ContactStiffness plane_stiffness(double e, double nu, PlaneState plane, double slenderness) {
  const double constrained =
      plane == PlaneState::stress ? e / (1.0 - nu * nu) : e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double shear = e / (2.0 * (1.0 + nu));
  return {.normal = constrained * slenderness, .shear = shear * slenderness};
}

ContactStiffness hexagonal_stiffness(double e, double nu, PlaneState plane) {
  if (plane == PlaneState::strain) {
    e /= 1.0 - nu * nu;
    nu /= 1.0 - nu;
  }
  const double root = std::sqrt(3.0) / 3.0;
  return {.normal = root * e / (1.0 - nu), .shear = root * (1.0 - 3.0 * nu) * e / (1.0 - nu * nu)};
}

}  // namespace

ContactStiffness contact_stiffness(const Material& material, PlaneState plane, double height, double length,
                                   double thickness) {
  ContactStiffness stiffness =
      material.stiffness == StiffnessFormula::plane
          ? plane_stiffness(material.young_modulus, material.poisson_ratio, plane, height / length)
          : hexagonal_stiffness(material.young_modulus, material.poisson_ratio, plane);
  stiffness.normal *= thickness;
  stiffness.shear *= thickness;
  stiffness.area = height * thickness;
  return stiffness;
}

double poisson_limit_of_hexagonal(PlaneState plane) { return plane == PlaneState::stress ? 1.0 / 3.0 : 0.25; }

}  // namespace ligament
