#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "support/hand_made_model.hpp"
#include "support/moved_bodies.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr double spacing = 2.0 * radius;
const double area_per_particle = 0.5 * std::sqrt(3.0) * spacing * spacing;

/// A disc and its six neighbours, and the neighbours of those, turned by an angle.
struct HexagonalPatch {
  Model model;
  State state;
  double thickness = 0.0;

  HexagonalPatch(const ModelChoice& choice, double angle) : model(empty_model(choice)), thickness(choice.thickness) {
    const Vector a = spacing * Vector{std::cos(angle), std::sin(angle)};
    const Vector b =
        spacing * Vector{std::cos(angle + std::numbers::pi / 3.0), std::sin(angle + std::numbers::pi / 3.0)};
    add_particle(model, {0.0, 0.0}, radius);
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) {
        if (i != 0 || j != 0) add_particle(model, static_cast<double>(i) * a + static_cast<double>(j) * b, radius);
      }
    }
    state = resting_state(model);
    GridContactDetector(1e-6).bond(model, state);
  }
  [[nodiscard]] double normal_stiffness() const { return state.particle_contacts.normal_stiffness[0]; }
  [[nodiscard]] double shear_stiffness() const { return state.particle_contacts.shear_stiffness[0]; }

  /// The energy that contacts of the first disc hold, halved: they are shared with the neighbours.
  [[nodiscard]] double energy_of_first() const {
    const ContactTable& contacts = state.particle_contacts;
    double energy = 0.0;
    int count = 0;
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      if (contacts.first[row] != 0) continue;
      ++count;
      energy += 0.5 * contacts.normal_force[row] * contacts.normal_force[row] / contacts.normal_stiffness[row] +
                0.5 * contacts.shear_force[row] * contacts.shear_force[row] / contacts.shear_stiffness[row];
    }
    REQUIRE(count == 6);
    return 0.5 * energy;
  }
  /// One step from rest to displacements and rotations that are functions of the place.
  template <class Displacement, class Turn>
  void deform(Displacement&& displacement, Turn&& turn) {
    for (std::size_t i = 0; i < model.particles.size(); ++i) {
      displace(state.particles.translation, i, displacement(model.particles.position[i]));
      rotate(state.particles.rotation, i, turn(model.particles.position[i]));
    }
    clear_forces(state);
    ContactForces<ParticlePairing>().add_forces(model, state);
  }
};

struct PlaneConstants {
  double young_modulus;
  double poisson_ratio;
};

/// Of the lattice, from its springs.
PlaneConstants constants_of(double k_n, double k_s, double thickness) {
  return {2.0 * std::sqrt(3.0) * k_n * (k_n + k_s) / (3.0 * k_n + k_s) / thickness, (k_n - k_s) / (3.0 * k_n + k_s)};
}

/// A plane strain tensor.
struct Strain {
  double xx;
  double yy;
  double xy;

  [[nodiscard]] Vector displacement(const Vector& place) const {
    return {xx * place.x + xy * place.y, xy * place.x + yy * place.y};
  }
  /// ½ ε : D : ε of plane stress (J/m3).
  [[nodiscard]] double energy(const PlaneConstants& constants) const {
    const double nu = constants.poisson_ratio;
    const double d = constants.young_modulus / (1.0 - nu * nu);
    return 0.5 * d * (xx * xx + yy * yy + 2.0 * nu * xx * yy + 2.0 * (1.0 - nu) * xy * xy);
  }
};

void check_uniform_strain(StiffnessFormula formula, double angle, const Strain& strain) {
  HexagonalPatch patch({.young_modulus = 20e9, .poisson_ratio = 0.2, .thickness = 0.5, .stiffness = formula}, angle);
  patch.deform([&](const Vector& x) { return strain.displacement(x); }, [](const Vector&) { return 0.0; });
  const PlaneConstants constants = constants_of(patch.normal_stiffness(), patch.shear_stiffness(), patch.thickness);
  if (formula == StiffnessFormula::hexagonal) {
    CHECK(constants.young_modulus == doctest::Approx(20e9).epsilon(1e-12));
    CHECK(constants.poisson_ratio == doctest::Approx(0.2).epsilon(1e-12));
  }
  CHECK(patch.energy_of_first() ==
        doctest::Approx(strain.energy(constants) * area_per_particle * patch.thickness).epsilon(1e-7));
  // The disc is in balance.
  const double scale = patch.normal_stiffness() * 1e-9 * spacing;
  CHECK(norm(patch.state.particles.translation.force[0]) < 1e-7 * scale);
  CHECK(std::abs(patch.state.particles.rotation.moment[0]) < 1e-7 * scale * radius);
}

}  // namespace

TEST_CASE("a hexagonal lattice under uniform strain stores what the continuum stores, in every direction") {
  for (const auto formula : {StiffnessFormula::hexagonal, StiffnessFormula::plane}) {
    for (const double angle : {0.0, 0.3, 0.5 * std::numbers::pi}) {
      for (const Strain& strain :
           {Strain{1e-9, 0.0, 0.0}, {0.0, 1e-9, 0.0}, {0.0, 0.0, 1e-9}, {1e-9, 1e-9, 0.0}, {7e-10, -3e-10, 4e-10}}) {
        check_uniform_strain(formula, angle, strain);
      }
    }
  }
}

namespace {

/// Answer of the first disc (force, moment) to a wave of displacement or rotation that has amplitude 1 at its place:
/// the dynamic matrix of the lattice, real for a lattice with inversion symmetry but for the coupling of displacement
/// and rotation, which is imaginary. Row and column 2: rotation.
struct DynamicMatrix {
  std::array<std::array<double, 3>, 3> even{};  ///< answer to cos(k·x)
  std::array<std::array<double, 3>, 3> odd{};   ///< answer to sin(k·x)

  DynamicMatrix(const ModelChoice& choice, double angle, const Vector& wave_number) {
    constexpr double amplitude = 1e-9;
    for (std::size_t freedom = 0; freedom < 3; ++freedom) {
      for (const bool is_even : {true, false}) {
        HexagonalPatch patch(choice, angle);
        const auto wave = [&](const Vector& x) {
          return amplitude * (is_even ? std::cos(dot(wave_number, x)) : std::sin(dot(wave_number, x)));
        };
        patch.deform(
            [&](const Vector& x) {
              return Vector{freedom == 0 ? wave(x) : 0.0, freedom == 1 ? wave(x) : 0.0};
            },
            [&](const Vector& x) { return freedom == 2 ? wave(x) : 0.0; });
        auto& answer = is_even ? even : odd;
        const Vector& force = patch.state.particles.translation.force[0];
        answer[0][freedom] = -force.x / amplitude;
        answer[1][freedom] = -force.y / amplitude;
        answer[2][freedom] = -patch.state.particles.rotation.moment[0] / amplitude;
      }
    }
  }
  /// Stiffness (N/m) against a slow wave of unit displacement u: rotations follow without inertia.
  [[nodiscard]] double stiffness_along(const Vector& u) const {
    const double direct = u.x * (even[0][0] * u.x + even[0][1] * u.y) + u.y * (even[1][0] * u.x + even[1][1] * u.y);
    const double moment = odd[2][0] * u.x + odd[2][1] * u.y;
    return direct - moment * moment / even[2][2];
  }
};

}  // namespace

TEST_CASE("long waves run through the lattice at √(C11/ρ) and √(C33/ρ), in every direction") {
  const ModelChoice choice{.young_modulus = 20e9, .poisson_ratio = 0.2, .stiffness = StiffnessFormula::hexagonal};
  const HexagonalPatch patch(choice, 0.0);
  const double k_n = patch.normal_stiffness();
  const double k_s = patch.shear_stiffness();
  const double density = patch.model.particles.real_mass[0] / area_per_particle;
  const double fast = std::sqrt(0.25 * std::sqrt(3.0) * (3.0 * k_n + k_s) / density);
  const double slow = std::sqrt(0.25 * std::sqrt(3.0) * (k_n + k_s) / density);
  // The same from the continuum.
  CHECK(fast == doctest::Approx(std::sqrt(20e9 / 0.96 / density)).epsilon(1e-12));
  CHECK(slow == doctest::Approx(std::sqrt(20e9 / 2.4 / density)).epsilon(1e-12));
  for (const double angle : {0.0, 0.2, 0.5 * std::numbers::pi}) {
    // 60 diameters.
    const double wave_number = 2.0 * std::numbers::pi / (60.0 * spacing);
    const DynamicMatrix matrix(choice, angle, {wave_number, 0.0});
    const double mass = patch.model.particles.real_mass[0];
    const auto speed = [&](const Vector& u) { return std::sqrt(matrix.stiffness_along(u) / mass) / wave_number; };
    // Dispersion: (k a)² / 24 and less.
    CHECK(speed({1.0, 0.0}) == doctest::Approx(fast).epsilon(1e-3));
    CHECK(speed({0.0, 1.0}) == doctest::Approx(slow).epsilon(1e-3));
    CHECK(speed({1.0, 0.0}) < fast);
  }
}
