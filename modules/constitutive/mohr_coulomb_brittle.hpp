#pragma once

#include "constitutive/mohr_coulomb_strength.hpp"

namespace ligament {

/// A Mohr-Coulomb bond that loses all its strength at once. The elastic energy that its springs lose with it is its
/// fracture energy, in the mode whose limit was reached. What is left is contact with friction.
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
  /// Where forces that change in proportion from one state to another leave what the bond carries.
  [[nodiscard]] ContactForce at_limit(double area, const ContactForce& from, double normal, ShearVector shear) const {
    const auto at = [&](double share) {
      return ContactForce{from.normal + share * (normal - from.normal), from.shear + share * (shear - from.shear),
                          BondState::bonded};
    };
    double inside = 0.0;
    double outside = 1.0;
    for (int bit = 0; bit < 53; ++bit) {
      const double middle = 0.5 * (inside + outside);
      const ContactForce force = at(middle);
      (intact_limits().carries(area, force.normal, force.shear) ? inside : outside) = middle;
    }
    return at(inside);
  }

  /// The break takes what the springs have stored at the limit, less what friction holds and its work: the energy does
  /// not depend on the step in which the limit is passed.
  void break_bond(const ContactInput& input, double normal, ShearVector shear, ContactForce& force,
                  History& history) const {
    const ContactForce limit = at_limit(input.area, force, normal, shear);
    const double friction_at_limit = friction_coefficient * std::max(0.0, limit.normal);
    const double size_at_limit = std::abs(limit.shear);
    const bool is_in_tension =
        -limit.normal / (tensile_strength * input.area) > size_at_limit / (cohesion * input.area + friction_at_limit);
    history[is_in_tension ? damage_tension : damage_shear] = 1.0;

    const double tension = std::min(0.0, limit.normal);
    const double beyond_friction = std::max(0.0, size_at_limit - friction_at_limit);
    history[is_in_tension ? fracture_tension : fracture_shear] +=
        0.5 * tension * tension / input.normal_stiffness +
        0.5 * beyond_friction * beyond_friction / input.shear_stiffness;

    // From the limit on it slides, at first over what the shear spring gives up.
    const double friction = friction_coefficient * std::max(0.0, normal);
    const double size = std::abs(shear);
    const double slid = std::max(0.0, size - friction) / input.shear_stiffness;
    const double slid_at_limit = beyond_friction / input.shear_stiffness;
    history[friction_work] +=
        friction_at_limit * slid_at_limit + 0.5 * (friction_at_limit + friction) * std::max(0.0, slid - slid_at_limit);
    force = {std::max(0.0, normal), size > friction ? friction / size * shear : shear, BondState::broken};
  }
};

}  // namespace ligament
