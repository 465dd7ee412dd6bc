#include <doctest/doctest.h>

#include <cmath>

#include "contact/contact_bound.hpp"
#include "contact/contact_stiffness.hpp"

using namespace ligament;

namespace {

Material material_with(double young_modulus, double poisson_ratio, StiffnessFormula formula) {
  Material material;
  material.young_modulus = young_modulus;
  material.poisson_ratio = poisson_ratio;
  material.stiffness = formula;
  return material;
}

}  // namespace

TEST_CASE("Eq. (33): springs of two discs from the constants of the continuum") {
  // E' = 15e9 / (1 - 0.09), E'' = 15e9 / 2.6, H/L = 0.02/0.025, t = 0.5.
  const Material material = material_with(15e9, 0.3, StiffnessFormula::plane);
  const auto stiffness = contact_stiffness(material, PlaneState::stress, 0.02, 0.025, 0.5);
  CHECK(stiffness.normal == doctest::Approx(6.593406593406593e9).epsilon(1e-14));
  CHECK(stiffness.shear == doctest::Approx(2.3076923076923077e9).epsilon(1e-14));
  CHECK(stiffness.area == doctest::Approx(0.01).epsilon(1e-14));
}

TEST_CASE("Eq. (33) in plane strain takes the constrained modulus") {
  const Material material = material_with(15e9, 0.3, StiffnessFormula::plane);
  const auto stiffness = contact_stiffness(material, PlaneState::strain, 1.0, 1.0, 1.0);
  CHECK(stiffness.normal == doctest::Approx(15e9 * 0.7 / (1.3 * 0.4)).epsilon(1e-14));
  CHECK(stiffness.shear == doctest::Approx(15e9 / 2.6).epsilon(1e-14));
}

TEST_CASE("Eq. (34): springs of a hexagonal assembly do not depend on size") {
  const Material material = material_with(20e9, 0.2, StiffnessFormula::hexagonal);
  for (const double size : {0.01, 0.04}) {
    const auto stiffness = contact_stiffness(material, PlaneState::stress, size, size, 0.05);
    CHECK(stiffness.normal == doctest::Approx(std::sqrt(3.0) * 20e9 / (3.0 * 0.8) * 0.05).epsilon(1e-14));
    CHECK(stiffness.shear == doctest::Approx(std::sqrt(3.0) * 0.4 * 20e9 / (3.0 * 0.96) * 0.05).epsilon(1e-14));
    CHECK(stiffness.area == doctest::Approx(size * 0.05).epsilon(1e-14));
  }
}

TEST_CASE("Eq. (34) gives back E and ν of the lattice, in plane stress and plane strain") {
  constexpr double e = 20e9;
  constexpr double nu = 0.2;
  const Material material = material_with(e, nu, StiffnessFormula::hexagonal);
  const auto lattice_e = [](const ContactStiffness& k) {
    return 2.0 * std::sqrt(3.0) * k.normal * (k.normal + k.shear) / (3.0 * k.normal + k.shear);
  };
  const auto lattice_nu = [](const ContactStiffness& k) { return (k.normal - k.shear) / (3.0 * k.normal + k.shear); };
  const auto stress = contact_stiffness(material, PlaneState::stress, 1.0, 1.0, 1.0);
  CHECK(lattice_e(stress) == doctest::Approx(e).epsilon(1e-14));
  CHECK(lattice_nu(stress) == doctest::Approx(nu).epsilon(1e-14));
  const auto strain = contact_stiffness(material, PlaneState::strain, 1.0, 1.0, 1.0);
  CHECK(lattice_e(strain) == doctest::Approx(e / (1.0 - nu * nu)).epsilon(1e-14));
  CHECK(lattice_nu(strain) == doctest::Approx(nu / (1.0 - nu)).epsilon(1e-14));
}

TEST_CASE("the shear stiffness of Eq. (34) vanishes at the limit of the Poisson ratio") {
  for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
    const double limit = poisson_limit_of_hexagonal(plane);
    const Material below = material_with(1.0, 0.99 * limit, StiffnessFormula::hexagonal);
    const Material above = material_with(1.0, 1.01 * limit, StiffnessFormula::hexagonal);
    CHECK(contact_stiffness(below, plane, 1.0, 1.0, 1.0).shear > 0.0);
    CHECK(contact_stiffness(above, plane, 1.0, 1.0, 1.0).shear < 0.0);
  }
}

TEST_CASE("the rows of a contact in the Gershgorin bound") {
  // Stiff shear: the translation follows it; levers 0.9 and 0.8.
  ContactBound bound = contact_bound(1.0, 2.0, 0.9, 0.8);
  CHECK(bound.translation == doctest::Approx(2.0 * 3.7).epsilon(1e-15));
  CHECK(bound.rotation_first == doctest::Approx(0.9 * 7.4).epsilon(1e-15));
  CHECK(bound.rotation_second == doctest::Approx(0.8 * 7.4).epsilon(1e-15));
  // Stiff normal spring.
  bound = contact_bound(10.0, 2.0, 1.0, 0.0);
  CHECK(bound.translation == doctest::Approx(20.0).epsilon(1e-15));
  CHECK(bound.rotation_first == doctest::Approx(6.0).epsilon(1e-15));
  CHECK(bound.rotation_second == 0.0);
  // A contact point beyond the centre of the second disc is a lever all the same.
  bound = contact_bound(1.0, 2.0, 1.5, -0.5);
  CHECK(bound.translation == doctest::Approx(8.0).epsilon(1e-15));
  CHECK(bound.rotation_second == doctest::Approx(4.0).epsilon(1e-15));
}
