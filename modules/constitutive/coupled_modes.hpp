#pragma once

#include "constitutive/softening_mode.hpp"

namespace ligament {

/// The damage of one mode, and the inelastic displacement behind it (m).
struct ModeDamage {
  double w = 0.0;
  double damage = 0.0;
};

struct BondDamage {
  ModeDamage tension;
  ModeDamage shear;
};

/// What a step asks of a mode: the displacement that spring and inelastic displacement share (m), and A/k of the spring
/// (m/Pa).
struct ModeDemand {
  double reach = 0.0;
  double flexibility = 0.0;
};

/// Tension and shear of a bond, each with its curve, that act on each other's strength.
template <SofteningCurve Curve>
struct CoupledModes {
  SofteningMode<Curve> tension;
  SofteningMode<Curve> shear;
  DamageCoupling coupling;

  /// Tension limit, and shear limit without friction, per area (Pa).
  [[nodiscard]] double tension_limit(const BondDamage& bond) const { return limit(tension, bond.tension, bond.shear); }
  [[nodiscard]] double shear_limit(const BondDamage& bond) const { return limit(shear, bond.shear, bond.tension); }

  /// Tension limit lost through shear damage (Pa).
  [[nodiscard]] double tension_lost(double tension_damage, double shear_damage) const {
    return tension.strength * strength_lost_to(coupling, tension_damage, shear_damage);
  }

  /// Damage at the end of a step. Where both modes grow they feed each other; the rounds go up to the least damage that
  /// carries the step, or to the break.
  [[nodiscard]] BondDamage grown(const BondDamage& before, const ModeDemand& in_tension,
                                 const ModeDemand& in_shear) const {
    constexpr int most_rounds = 100;
    constexpr double rounding = 1e-15;
    BondDamage bond = before;
    for (int round = 0; round < most_rounds; ++round) {
      const double shear_damage = bond.shear.damage;
      grow(tension, in_tension, bond.tension, bond.shear);
      grow(shear, in_shear, bond.shear, bond.tension);
      if (bond.shear.damage <= shear_damage + rounding) break;
      // Both go on growing until the step is carried.
      const bool both_grow = bond.tension.w > before.tension.w;
      if (coupling == DamageCoupling::sum && both_grow && grow_together(in_tension, in_shear, bond)) break;
    }
    return bond;
  }

  /// Whether both modes grow on straight lines between two states before the break, as one sum.
  [[nodiscard]] bool grow_straight(const BondDamage& before, const BondDamage& now) const {
    return coupling != DamageCoupling::largest && strength_left(coupling, now.tension.damage, now.shear.damage) > 0.0 &&
           tension.is_straight(before.tension.w, now.tension.w) && shear.is_straight(before.shear.w, now.shear.w);
  }

  /// What ∫f s dw of a step has too much, because the other mode has damage, too (J/m2).
  [[nodiscard]] double tension_work_lost(const BondDamage& before, const BondDamage& now) const {
    return work_lost(tension, before.tension, now.tension, before.shear, now.shear);
  }
  [[nodiscard]] double shear_work_lost(const BondDamage& before, const BondDamage& now) const {
    return work_lost(shear, before.shear, now.shear, before.tension, now.tension);
  }

 private:
  [[nodiscard]] double limit(const SofteningMode<Curve>& mode, const ModeDamage& own, const ModeDamage& other) const {
    return mode.strength * strength_left(coupling, own.damage, other.damage);
  }

  void grow(const SofteningMode<Curve>& mode, const ModeDemand& demand, ModeDamage& own,
            const ModeDamage& other) const {
    if (demand.reach <= own.w + limit(mode, own, other) * demand.flexibility) return;
    own.w = std::max(own.w, mode.inelastic(demand.reach, demand.flexibility, coupling, other.damage));
    own.damage = std::max(own.damage, mode.damage(own.w));
  }

  /// Where both modes grow, the part L of the strengths that is left solves L = s(w_t(L)) + s(w_s(L)) - 1, with
  /// w = reach - L f A/k. What the right side has too much is a convex function of L, so that Newton's iteration from
  /// L = 0 goes up to the least damage and no further. False if the bond breaks.
  bool grow_together(const ModeDemand& in_tension, const ModeDemand& in_shear, BondDamage& bond) const {
    constexpr int most_iterations = 60;
    constexpr double rounding = 1e-15;
    double left = 0.0;
    for (int i = 0; i < most_iterations; ++i) {
      const double tension_w = tension.plastic(in_tension.reach, in_tension.flexibility, left);
      const double shear_w = shear.plastic(in_shear.reach, in_shear.flexibility, left);
      const double tension_damage = tension.damage(tension_w);
      const double shear_damage = shear.damage(shear_w);
      const double excess = 1.0 - tension_damage - shear_damage - left;
      if (i == 0 && !(excess > 0.0)) return false;
      if (excess <= rounding) {
        bond = {{tension_w, tension_damage}, {shear_w, shear_damage}};
        return true;
      }
      left += excess / (1.0 - tension.softening(tension_w, in_tension.flexibility) -
                        shear.softening(shear_w, in_shear.flexibility));
    }
    return false;
  }

  [[nodiscard]] double work_lost(const SofteningMode<Curve>& mode, const ModeDamage& before, const ModeDamage& now,
                                 const ModeDamage& other_before, const ModeDamage& other_now) const {
    if (now.w == before.w || other_now.damage == 0.0) return 0.0;
    return mode.work_lost(before.w, now.w, coupling, 0.5 * (other_before.damage + other_now.damage));
  }
};

}  // namespace ligament
