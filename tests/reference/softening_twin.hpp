#pragma once

#include <cmath>

/// The softening bond written out once more, without sharing code with the program: tiny substeps, limits from the
/// damage of the substep before, energies from the work of the forces.
namespace ligament::reference {

/// Rokugo's one-fourth law, w in metres.
inline double one_fourth_law(double w, double strength, double fracture_energy) {
  const double unit = fracture_energy / strength;
  if (w < 0.75 * unit) return 1.0 - w / unit;
  if (w < 5.0 * unit) return 0.25 * (5.0 * unit - w) / (4.25 * unit);
  return 0.0;
}

/// e^(-w f/G) to its fifth unit, then a straight line that ends where the area is G.
inline double exponential_law(double w, double strength, double fracture_energy) {
  const double unit = fracture_energy / strength;
  if (w < 5.0 * unit) return std::exp(-w / unit);
  if (w < 7.0 * unit) return std::exp(-5.0) * (7.0 * unit - w) / (2.0 * unit);
  return 0.0;
}

/// Share of the strength that is left after an inelastic displacement w, of the strength and the fracture energy.
using SofteningLaw = double (*)(double w, double strength, double fracture_energy);

/// Secant unloading, sum of damages.
struct SofteningTwin {
  SofteningLaw law = one_fourth_law;
  double k_n = 0.0, k_s = 0.0, area = 0.0;
  double tensile_strength = 0.0, cohesion = 0.0, friction_coefficient = 0.0, energy_tension = 0.0, energy_shear = 0.0;

  double opening = 0.0, normal = 0.0, shear = 0.0;
  double w_tension = 0.0, w_shear = 0.0, damage = 0.0;
  double work = 0.0, friction_work = 0.0;

  void move(double opened, double slipped, int n_substeps) {
    for (int i = 0; i < n_substeps; ++i) substep(opened / n_substeps, slipped / n_substeps);
  }

  double stored() const {
    const double of_normal = normal < 0.0 ? -0.5 * normal * opening : 0.5 * normal * normal / k_n;
    return of_normal + 0.5 * shear * shear / k_s;
  }
  double fracture() const { return work - stored() - friction_work; }

 private:
  void substep(double opened, double slipped) {
    const double normal_before = normal;
    const double shear_before = shear;
    opening += opened;
    normal = -k_n * opening;
    const double limit = (1.0 - damage) * tensile_strength * area;
    if (opening > 0.0) {
      const double peak = w_tension + limit / k_n;
      normal = opening < peak ? -limit * opening / peak : -limit;
      w_tension = std::fmax(w_tension, opening + normal / k_n);
    }
    const double friction = normal > 0.0 ? friction_coefficient * normal : 0.0;
    const double shear_limit = (1.0 - damage) * cohesion * area + friction;
    shear -= k_s * slipped;
    if (std::fabs(shear) > shear_limit) {
      const double slip = (std::fabs(shear) - shear_limit) / k_s;
      w_shear += slip;
      friction_work += friction * slip;
      shear = shear > 0.0 ? shear_limit : -shear_limit;
    }
    const double left = law(w_tension, tensile_strength, energy_tension) + law(w_shear, cohesion, energy_shear) - 1.0;
    damage = std::fmax(damage, std::fmin(1.0, 1.0 - left));
    work -= 0.5 * ((normal_before + normal) * opened + (shear_before + shear) * slipped);
  }
};

}  // namespace ligament::reference
