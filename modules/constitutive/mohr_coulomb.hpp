#pragma once

#include "constitutive/coupled_modes.hpp"
#include "constitutive/mohr_coulomb_strength.hpp"
#include "constitutive/strides.hpp"

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

  /// Takes the step of a contact without intact bond on which nothing grows or slips: its history, of which
  /// remembered(k) is a variable, stays as it is. False if it does not; the force is then as it was.
  template <class Remembered>
  bool keeps_history(const ContactInput& input, ContactForce& force, Remembered&& remembered) const {
    if (force.bond == BondState::bonded) return false;
    const double pressure = pressure_at(input, input.opening);
    const double least_friction = friction_coefficient * std::min(std::max(0.0, force.normal), pressure);
    const ShearVector trial = force.shear - input.shear_stiffness * input.slip_increment;
    const double largest_shear = std::max(std::abs(force.shear), std::abs(trial));
    if (force.bond != BondState::softening) {
      if (largest_shear > least_friction) return false;
      force.normal = pressure;
      force.shear = trial;
      return true;
    }
    const BondDamage bond{{remembered(opening_inelastic), remembered(damage_tension)},
                          {remembered(slip_inelastic), remembered(damage_shear)}};
    const double reach = bond.tension.w + modes().tension_limit(bond) * input.area / input.normal_stiffness;
    if (input.opening > reach || largest_shear > modes().shear_limit(bond) * input.area + least_friction) return false;
    force.normal = pressure - tension_force(input, bond);
    force.shear = trial;
    return true;
  }

  void evaluate(const ContactInput& input, ContactForce& force, History& history) const {
    if (keeps_history(input, force, [&](std::size_t k) { return history[k]; })) return;
    const double normal = -input.normal_stiffness * input.opening;
    const ShearVector shear = force.shear - input.shear_stiffness * input.slip_increment;
    if (force.bond == BondState::bonded && intact_limits().carries(input.area, normal, shear)) {
      force.normal = normal;
      force.shear = shear;
    } else if (force.bond == BondState::bonded || force.bond == BondState::softening) {
      soften_on_the_way(input, force, history);
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

  [[nodiscard]] ContactDamage damage(const History& history) const {
    return combined_damage(coupling, history[damage_tension], history[damage_shear]);
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

  [[nodiscard]] CoupledModes<Curve> modes() const { return {tension(), shear(), coupling}; }

  /// A long way is taken in parts, straight from the old opening to the new: where both modes grow, what a step spends
  /// and leaves depends on the order in which they do. Parts on which it does not are taken at once.
  void soften_on_the_way(const ContactInput& input, ContactForce& force, History& history) const {
    const double opening_before = opening_of(input, force, history);
    const double parts_to_the_end = 512.0;
    const double way = std::max(std::abs(input.opening - opening_before) / tension().end(),
                                std::abs(input.slip_increment) / shear().end());
    const double n_parts = std::clamp(std::ceil(parts_to_the_end * way), 1.0, 4.0 * parts_to_the_end);
    const auto opening_at = [&](double part) {
      return input.opening - (n_parts - part) / n_parts * (input.opening - opening_before);
    };
    ContactInput stride = input;
    walk_in_strides(n_parts, [&](double from, double to) {
      const double from_opening = opening_at(from);
      stride.opening = opening_at(to);
      stride.slip_increment = (to - from) / n_parts * input.slip_increment;
      const bool is_one_part = to - from == 1.0;
      if (force.bond == BondState::broken) {
        const bool is_even = std::min(from_opening, stride.opening) >= 0.0;
        if (!is_even && !is_one_part) return Stride::refused;
        slide(stride, force, history[friction_work]);
        return is_even ? Stride::even : Stride::uneven;
      }
      const Growth growth = growth_in(stride, force, history);
      const bool is_even = n_parts > 1.0 && this->is_even(stride, from_opening, force, growth);
      if (!is_even && !is_one_part) return Stride::refused;
      soften(stride, growth, force, history);
      return is_even ? Stride::even : Stride::uneven;
    });
  }

  /// The opening at which a bond has its force (m).
  [[nodiscard]] double opening_of(const ContactInput& input, const ContactForce& force, const History& history) const {
    const double elastic = -force.normal / input.normal_stiffness;
    const double w = history[opening_inelastic];
    if (!(force.normal < 0.0) || w == 0.0) return elastic;
    if (unloading == Unloading::elastic) return elastic + w;
    const BondDamage bond{{w, history[damage_tension]}, {history[slip_inelastic], history[damage_shear]}};
    const double limit = modes().tension_limit(bond) * input.area;
    return elastic * (1.0 + input.normal_stiffness * w / limit);
  }

  /// What a step makes of a bond.
  struct Growth {
    BondDamage before;
    BondDamage now;
    double pressure;    ///< (N)
    ShearVector trial;  ///< shear force without slip (N)
    double limit;       ///< of shear (N)
    double slip;        ///< (m)

    [[nodiscard]] bool in_tension() const { return now.tension.w != before.tension.w; }
    [[nodiscard]] bool in_shear() const { return now.shear.w != before.shear.w; }
  };

  [[nodiscard]] Growth growth_in(const ContactInput& input, const ContactForce& force, const History& history) const {
    Growth growth{.before = {{history[opening_inelastic], history[damage_tension]},
                             {history[slip_inelastic], history[damage_shear]}},
                  .pressure = pressure_at(input, input.opening),
                  .trial = force.shear - input.shear_stiffness * input.slip_increment};
    const double friction = friction_coefficient * growth.pressure;
    const double trial_size = std::abs(growth.trial);
    const double slip_reach = growth.before.shear.w + (trial_size - friction) / input.shear_stiffness;
    growth.now = modes().grown(growth.before, {input.opening, input.area / input.normal_stiffness},
                               {slip_reach, input.area / input.shear_stiffness});
    growth.limit = modes().shear_limit(growth.now) * input.area + friction;
    growth.slip = std::max(0.0, trial_size - growth.limit) / input.shear_stiffness;
    return growth;
  }

  [[nodiscard]] static double pressure_at(const ContactInput& input, double opening) {
    return std::max(0.0, -input.normal_stiffness * opening);
  }

  /// Whether a step straight from an opening does the same as many parts of it.
  [[nodiscard]] bool is_even(const ContactInput& input, double from, const ContactForce& force,
                             const Growth& growth) const {
    const double flexibility = input.area / input.normal_stiffness;
    const double least_pressure = std::min(pressure_at(input, from), growth.pressure);
    const double shear_before = std::abs(force.shear);
    const double cohesive = modes().shear_limit(growth.now) * input.area;
    if (!growth.in_shear()) {
      // Nowhere on the way does anything slip, and tension alone has closed forms.
      const double largest_shear = std::max(shear_before, std::abs(growth.trial));
      return growth.slip == 0.0 && largest_shear <= cohesive + friction_coefficient * least_pressure;
    }
    if (friction_coefficient > 0.0 && std::min(from, input.opening) < 0.0) return false;
    // So has shear alone.
    if (growth.now.tension.w == 0.0) {
      return std::max(from, input.opening) <= modes().tension_limit(growth.now) * flexibility;
    }
    // Both grow all the way, in proportion to it.
    constexpr double at_the_limit = 1.0 - 1e-12;
    const double reach = growth.before.tension.w + modes().tension_limit(growth.before) * flexibility;
    return growth.in_tension() && from >= at_the_limit * reach &&
           shear_before >= at_the_limit * modes().shear_limit(growth.before) * input.area &&
           force.shear * growth.trial > 0.0 && modes().grow_straight(growth.before, growth.now);
  }

  void soften(const ContactInput& input, const Growth& growth, ContactForce& force, History& history) const {
    const BondDamage& now = growth.now;
    const double pull = tension_force(input, now);
    history[friction_work] +=
        0.5 * friction_coefficient * (std::max(0.0, force.normal) + growth.pressure) * growth.slip;
    if (growth.in_tension() || growth.in_shear()) {
      book_coupling(input, -force.normal, pull, growth.before, now, history);
      history[opening_inelastic] = now.tension.w;
      history[slip_inelastic] = now.shear.w;
      history[damage_tension] = now.tension.damage;
      history[damage_shear] = now.shear.damage;
    }
    force.normal = growth.pressure - pull;
    force.shear = growth.slip > 0.0 ? growth.limit / std::abs(growth.trial) * growth.trial : growth.trial;
    force.bond = is_broken(coupling, now.tension.damage, now.shear.damage) ? BondState::broken : BondState::softening;
  }

  /// Tension (N), none in compression.
  [[nodiscard]] double tension_force(const ContactInput& input, const BondDamage& bond) const {
    const double limit = modes().tension_limit(bond) * input.area;
    if (input.opening <= 0.0 || limit <= 0.0) return 0.0;
    const double plastic = input.normal_stiffness * bond.tension.w;
    const double elastic = input.normal_stiffness * input.opening;
    return std::min(limit, unloading == Unloading::secant ? elastic * (limit / (limit + plastic))
                                                          : std::max(0.0, elastic - plastic));
  }

  /// What the closed forms, which know one mode each, miss in a step in which the other mode has damage.
  void book_coupling(const ContactInput& input, double pull_before, double pull, const BondDamage& before,
                     const BondDamage& now, History& history) const {
    history[coupling_tension] -= input.area * modes().tension_work_lost(before, now);
    history[coupling_shear] -= input.area * modes().shear_work_lost(before, now);
    if (unloading == Unloading::elastic) return;

    // The triangle below the secant, ½ (limit) w, shrinks with the limit: by growth of w, or at a fixed w through
    // shear.
    const double lost_before = modes().tension_lost(before.tension.damage, before.shear.damage);
    const double lost_now = modes().tension_lost(now.tension.damage, now.shear.damage);
    const double lost_but_for_shear = modes().tension_lost(now.tension.damage, before.shear.damage);
    const double share = now.tension.w > before.tension.w
                             ? 1.0
                             : 0.5 * (loading_squared(input, before, pull_before) + loading_squared(input, now, pull));
    const double half_area = 0.5 * input.area * share;
    const double all = half_area * (now.tension.w * lost_now - before.tension.w * lost_before);
    const double by_shear = half_area * 0.5 * (before.tension.w + now.tension.w) * (lost_now - lost_but_for_shear);
    history[coupling_tension] += all - by_shear;
    history[coupling_shear] += by_shear;
  }

  /// (T/T_limit)²: how much of the energy that a bond stores at its limit it stores.
  [[nodiscard]] double loading_squared(const ContactInput& input, const BondDamage& bond, double pull) const {
    const double limit = modes().tension_limit(bond) * input.area;
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
