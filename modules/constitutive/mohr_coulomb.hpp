#pragma once

#include "constitutive/mohr_coulomb_strength.hpp"
#include "constitutive/softening_mode.hpp"

namespace ligament {

/// How a bond that has opened inelastically closes again.
enum class Unloading {
  secant,   ///< along a straight line to the reference gap
  elastic,  ///< along k_n to a permanent opening, free of force until the reference gap is closed
};

/// A bond with the tension limit (1 - D) σ_t A and the shear limit (1 - D) C A + μ F_n, F_n > 0, which
/// soften along a curve s(w): D_t = 1 - s(w_t), D_s = 1 - s(w_s). w_t is the largest opening less that of the spring,
/// w_s the accumulated slip less that of the spring. Limits and w of a step are solved together. At D = 1 the bond is
/// broken: what is left is contact with friction. docs/theory.md, section 4, derives what it stores and spends.
template <SofteningCurve Curve>
struct MohrCoulomb : MohrCoulombStrength {
  enum Variable : std::size_t {
    opening_inelastic,
    slip_inelastic,
    damage_tension,
    damage_shear,
    friction_work,
    coupling_tension,
    coupling_shear,
    n_history
  };
  using History = std::array<double, n_history>;

  static std::array<HistoryVariable, n_history> history() {
    return {HistoryVariable{"opening_inelastic", "m", 0.0},  // w_t
            HistoryVariable{"slip_inelastic", "m", 0.0},     // w_s
            HistoryVariable{"damage_tension", "1", 0.0},     // D_t
            HistoryVariable{"damage_shear", "1", 0.0},       // D_s
            HistoryVariable{"friction_work", "J", 0.0},
            // What the coupling of the damages adds to the closed forms of the fracture energies.
            HistoryVariable{"coupling_tension", "J", 0.0}, HistoryVariable{"coupling_shear", "J", 0.0}};
  }

  double fracture_energy_tension = 0.0;  ///< G_ft (J/m2)
  double fracture_energy_shear = 0.0;    ///< G_fc (J/m2)
  DamageCoupling coupling = DamageCoupling::sum;
  Unloading unloading = Unloading::secant;
  Curve curve;

  void declare(Parameters& parameters);

  void evaluate(const ContactInput& input, ContactForce& force, History& history) const {
    const double normal = -input.normal_stiffness * input.opening;
    const ShearVector shear = force.shear - input.shear_stiffness * input.slip_increment;
    if (force.bond == BondState::bonded && carries(input.area, normal, shear)) {
      force.normal = normal;
      force.shear = shear;
    } else if (force.bond == BondState::bonded || force.bond == BondState::softening) {
      soften(input, shear, force, history);
    } else {
      slide(input, force, history[friction_work]);
    }
  }

  [[nodiscard]] ContactEnergies energies(const ContactInput& input, const ContactForce& force,
                                         const History& history) const {
    const bool is_secant = force.normal < 0.0 && unloading == Unloading::secant;
    const double w = history[opening_inelastic];
    return {.elastic_normal = is_secant ? -0.5 * force.normal * input.opening
                                        : 0.5 * force.normal * force.normal / input.normal_stiffness,
            .elastic_shear = 0.5 * force.shear * force.shear / input.shear_stiffness,
            .fracture_tension =
                history[coupling_tension] +
                input.area * (unloading == Unloading::secant ? tension().work_less_secant(w) : tension().work(w)),
            .fracture_shear = history[coupling_shear] + input.area * shear().work(history[slip_inelastic]),
            .friction = history[friction_work]};
  }

  [[nodiscard]] std::optional<LawComplaint> complaint(const ContactSample& contact) const {
    const auto of_tension = tension().complaint("fracture_energy_tension", contact.area / contact.normal_stiffness);
    const auto of_shear = shear().complaint("fracture_energy_shear", contact.area / contact.shear_stiffness);
    if (!of_tension || !of_shear) return of_tension ? of_tension : of_shear;
    return of_tension->severity >= of_shear->severity ? of_tension : of_shear;
  }

 private:
  [[nodiscard]] SofteningMode<Curve> tension() const { return {curve, tensile_strength, fracture_energy_tension}; }
  [[nodiscard]] SofteningMode<Curve> shear() const { return {curve, cohesion, fracture_energy_shear}; }

  /// The damage of one mode, and the inelastic displacement behind it (m).
  struct ModeDamage {
    double w = 0.0;
    double damage = 0.0;
  };
  struct BondDamage {
    ModeDamage tension;
    ModeDamage shear;
  };

  void soften(const ContactInput& input, ShearVector trial, ContactForce& force, History& history) const {
    const BondDamage before{{history[opening_inelastic], history[damage_tension]},
                            {history[slip_inelastic], history[damage_shear]}};
    const double pressure = std::max(0.0, -input.normal_stiffness * input.opening);
    const double friction = friction_coefficient * pressure;
    const double trial_size = std::abs(trial);
    const double slip_reach = before.shear.w + (trial_size - friction) / input.shear_stiffness;
    const BondDamage now = grown(before, input, slip_reach);

    const double limit = cohesion * input.area * left(now.shear, now.tension) + friction;
    const double pull = input.opening > 0.0 ? tension_force(input, now) : 0.0;
    const double slip = std::max(0.0, trial_size - limit) / input.shear_stiffness;
    history[friction_work] += 0.5 * friction_coefficient * (std::max(0.0, force.normal) + pressure) * slip;
    if (now.tension.w != before.tension.w || now.shear.w != before.shear.w) {
      book_coupling(input, -force.normal, pull, before, now, history);
      history[opening_inelastic] = now.tension.w;
      history[slip_inelastic] = now.shear.w;
      history[damage_tension] = now.tension.damage;
      history[damage_shear] = now.shear.damage;
    }
    force.normal = pressure - pull;
    force.shear = slip > 0.0 ? limit / trial_size * trial : trial;
    force.bond = is_broken(coupling, now.tension.damage, now.shear.damage) ? BondState::broken : BondState::softening;
  }

  [[nodiscard]] double left(const ModeDamage& own, const ModeDamage& other) const {
    return strength_left(coupling, own.damage, other.damage);
  }
  [[nodiscard]] double lost(const ModeDamage& own, const ModeDamage& other) const {
    return strength_lost_to(coupling, own.damage, other.damage);
  }

  /// Damage of both modes at the end of the step. Where both grow they feed each other; the rounds go up to the least
  /// damage that carries the step, or to the break.
  [[nodiscard]] BondDamage grown(BondDamage bond, const ContactInput& input, double slip_reach) const {
    constexpr int most_rounds = 100;
    constexpr double rounding = 1e-15;
    for (int round = 0; round < most_rounds; ++round) {
      const double shear_damage = bond.shear.damage;
      grow(tension(), input.opening, input.area / input.normal_stiffness, bond.tension, bond.shear);
      grow(shear(), slip_reach, input.area / input.shear_stiffness, bond.shear, bond.tension);
      if (bond.shear.damage <= shear_damage + rounding) break;
    }
    return bond;
  }

  void grow(const SofteningMode<Curve>& mode, double reach, double flexibility, ModeDamage& own,
            const ModeDamage& other) const {
    if (reach <= own.w + left(own, other) * mode.strength * flexibility) return;
    own.w = std::max(own.w, mode.inelastic(reach, flexibility, coupling, other.damage));
    own.damage = std::max(own.damage, mode.damage(own.w));
  }

  /// Tension at an opening > 0 (N).
  [[nodiscard]] double tension_force(const ContactInput& input, const BondDamage& bond) const {
    const double limit = tensile_strength * input.area * left(bond.tension, bond.shear);
    if (limit <= 0.0) return 0.0;
    const double plastic = input.normal_stiffness * bond.tension.w;
    const double elastic = input.normal_stiffness * input.opening;
    return std::min(limit, unloading == Unloading::secant ? elastic * (limit / (limit + plastic))
                                                          : std::max(0.0, elastic - plastic));
  }

  /// What the closed forms, which know one mode each, miss in a step in which the other mode has damage.
  void book_coupling(const ContactInput& input, double pull_before, double pull, const BondDamage& before,
                     const BondDamage& now, History& history) const {
    history[coupling_tension] -=
        input.area * work_lost(tension(), before.tension, now.tension, before.shear, now.shear);
    history[coupling_shear] -= input.area * work_lost(shear(), before.shear, now.shear, before.tension, now.tension);
    if (unloading == Unloading::elastic) return;

    // The triangle below the secant shrinks with the strength: by growth of w, or at a fixed w through shear.
    const double lost_before = lost(before.tension, before.shear);
    const double lost_now = lost(now.tension, now.shear);
    if (lost_now == 0.0) return;
    const double share = now.tension.w > before.tension.w
                             ? 1.0
                             : 0.5 * (loading_squared(input, before, pull_before) + loading_squared(input, now, pull));
    const double half_strength = 0.5 * tensile_strength * input.area * share;
    const double all = half_strength * (now.tension.w * lost_now - before.tension.w * lost_before);
    const double by_shear =
        half_strength * 0.5 * (before.tension.w + now.tension.w) * (lost_now - lost(now.tension, before.shear));
    history[coupling_tension] += all - by_shear;
    history[coupling_shear] += by_shear;
  }

  [[nodiscard]] double work_lost(const SofteningMode<Curve>& mode, const ModeDamage& before, const ModeDamage& now,
                                 const ModeDamage& other_before, const ModeDamage& other_now) const {
    if (now.w == before.w || other_now.damage == 0.0) return 0.0;
    return mode.work_lost(before.w, now.w, coupling, 0.5 * (other_before.damage + other_now.damage));
  }

  /// (T/T_limit)²: how much of the energy that a bond stores at its limit it stores.
  [[nodiscard]] double loading_squared(const ContactInput& input, const BondDamage& bond, double pull) const {
    const double limit = tensile_strength * input.area * left(bond.tension, bond.shear);
    const double ratio = limit > 0.0 ? std::clamp(pull / limit, 0.0, 1.0) : 0.0;
    return ratio * ratio;
  }
};

template <SofteningCurve Curve>
void MohrCoulomb<Curve>::declare(Parameters& parameters) {
  MohrCoulombStrength::declare(parameters);
  parameters
      .quantity("fracture_energy_tension", fracture_energy_tension, "J/m2",
                "energy G_ft that breaks a bond in tension, per area")
      .required()
      .greater_than(0.0);
  parameters
      .quantity("fracture_energy_shear", fracture_energy_shear, "J/m2",
                "energy G_fc that breaks a bond in shear, per area, friction left out")
      .required()
      .greater_than(0.0);
  parameters.choice(
      "coupling", coupling,
      {{"sum", DamageCoupling::sum}, {"largest", DamageCoupling::largest}, {"none", DamageCoupling::none}},
      "which damage reduces both strengths: the sum of those of tension and shear, the larger one, or each its own");
  parameters.choice("unloading", unloading, {{"secant", Unloading::secant}, {"elastic", Unloading::elastic}},
                    "how a bond that softens in tension closes: straight to the reference gap, or along k_n");
}

}  // namespace ligament
