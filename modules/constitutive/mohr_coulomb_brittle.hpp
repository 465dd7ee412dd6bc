#pragma once

#include "constitutive/mohr_coulomb_strength.hpp"

namespace ligament {

/// A Mohr-Coulomb bond that loses all its strength at once. The elastic energy that its springs lose with it is its
/// fracture energy, in the mode whose limit was exceeded by more. What is left is contact with friction.
struct MohrCoulombBrittle : MohrCoulombStrength {
  enum Variable : std::size_t {
    damage_tension,
    damage_shear,
    friction_work,
    fracture_tension,
    fracture_shear,
    n_history
  };
  using History = std::array<double, n_history>;

  static std::array<HistoryVariable, n_history> history() {
    return {HistoryVariable{"damage_tension", "1", 0.0}, HistoryVariable{"damage_shear", "1", 0.0},
            HistoryVariable{"friction_work", "J", 0.0}, HistoryVariable{"fracture_tension", "J", 0.0},
            HistoryVariable{"fracture_shear", "J", 0.0}};
  }

  void evaluate(const ContactInput& input, ContactForce& force, History& history) const {
    if (force.bond != BondState::bonded) return slide(input, force, history[friction_work]);
    const double normal = -input.normal_stiffness * input.opening;
    const ShearVector shear = force.shear - input.shear_stiffness * input.slip_increment;
    if (intact_limits().carries(input.area, normal, shear)) {
      force.normal = normal;
      force.shear = shear;
    } else {
      break_bond(input, normal, shear, force, history);
    }
  }

  [[nodiscard]] ContactEnergies energies(const ContactInput& input, const ContactForce& force,
                                         const History& history) const {
    return {.elastic_normal = 0.5 * force.normal * force.normal / input.normal_stiffness,
            .elastic_shear = 0.5 * force.shear * force.shear / input.shear_stiffness,
            .fracture_tension = history[fracture_tension],
            .fracture_shear = history[fracture_shear],
            .friction = history[friction_work]};
  }

  [[nodiscard]] ContactDamage damage(const History& history) const {
    if (history[damage_tension] > 0.0) return {history[damage_tension], FractureMode::tension};
    if (history[damage_shear] > 0.0) return {history[damage_shear], FractureMode::shear};
    return {};
  }

 private:
  void break_bond(const ContactInput& input, double normal, ShearVector shear, ContactForce& force,
                  History& history) const {
    const double friction = friction_coefficient * std::max(0.0, normal);
    const double size = std::abs(shear);
    const bool is_in_tension = -normal / (tensile_strength * input.area) > size / (cohesion * input.area + friction);
    history[is_in_tension ? damage_tension : damage_shear] = 1.0;

    const ContactForce now{std::max(0.0, normal), size > friction ? friction / size * shear : shear, BondState::broken};
    // The slip of the shear spring works on the friction; the rest of the work, and what opening sets free, is
    // fracture.
    const double released = elastic_loss(force.normal, normal, now.normal, input.normal_stiffness) +
                            elastic_loss(force.shear, shear, now.shear, input.shear_stiffness);
    history[is_in_tension ? fracture_tension : fracture_shear] += released;
    history[friction_work] += now.shear * (shear - now.shear) / input.shear_stiffness;
    force = now;
  }

  /// Work of a force that falls from its trial value to another one beyond that other one. With the force of the step
  /// before as the mean demands, so that the ledger closes: ½ (F(n-1) - F(n)) (F_trial - F(n)) / k.
  static double elastic_loss(double before, double trial, double now, double stiffness) {
    return std::max(0.0, 0.5 * (before - now) * (trial - now) / stiffness);
  }
};

}  // namespace ligament
