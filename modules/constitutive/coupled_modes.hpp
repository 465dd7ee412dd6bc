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
  [[nodiscard]] BondDamage grown(BondDamage bond, const ModeDemand& in_tension, const ModeDemand& in_shear) const {
    constexpr int most_rounds = 100;
    constexpr double rounding = 1e-15;
    for (int round = 0; round < most_rounds; ++round) {
      const double shear_damage = bond.shear.damage;
      grow(tension, in_tension, bond.tension, bond.shear);
      grow(shear, in_shear, bond.shear, bond.tension);
      if (bond.shear.damage <= shear_damage + rounding) break;
    }
    return bond;
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

  [[nodiscard]] double work_lost(const SofteningMode<Curve>& mode, const ModeDamage& before, const ModeDamage& now,
                                 const ModeDamage& other_before, const ModeDamage& other_now) const {
    if (now.w == before.w || other_now.damage == 0.0) return 0.0;
    return mode.work_lost(before.w, now.w, coupling, 0.5 * (other_before.damage + other_now.damage));
  }
};

}  // namespace ligament
