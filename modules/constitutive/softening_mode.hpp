#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "constitutive/damage_coupling.hpp"
#include "constitutive/softening_curve.hpp"
#include "core/constitutive_law.hpp"

namespace ligament {

/// One of the two ways in which a bond fails, per area: strength f, fracture energy G, and the curve between them.
template <SofteningCurve Curve>
struct SofteningMode {
  const Curve& curve;
  double strength = 0.0;         ///< f (Pa)
  double fracture_energy = 0.0;  ///< G (J/m2)

  /// x = w f/G.
  [[nodiscard]] double relative(double w) const { return w * strength / fracture_energy; }

  /// The inelastic displacement at the break (m).
  [[nodiscard]] double end() const { return curve.end() * fracture_energy / strength; }

  /// The least inelastic displacement w (m), at most that of the break, with w + r(w) f A/k = reach: r is the part of
  /// the strength that is left beside the damage of the other mode, and r f A/k what the spring takes of the
  /// displacement.
  [[nodiscard]] double inelastic(double reach, double flexibility, DamageCoupling coupling, double other_damage) const {
    const double a = relative(strength * flexibility);
    const double r = relative(reach);
    return solve(a, r, coupling, other_damage) * fracture_energy / strength;
  }
  /// The inelastic displacement (m), at most that of the break, of a displacement `reach` at this part of the strength.
  [[nodiscard]] double plastic(double reach, double flexibility, double part) const {
    return std::min(reach - part * strength * flexibility, end());
  }
  /// How fast s falls where the spring gives way, -ds/dw · f A/k.
  [[nodiscard]] double softening(double w, double flexibility) const {
    return curve.slope(relative(w)) * relative(strength * flexibility);
  }
  [[nodiscard]] bool is_straight(double from, double to) const {
    return curve.is_straight(relative(from), relative(to));
  }
  /// 1 - s(w).
  [[nodiscard]] double damage(double w) const { return 1.0 - curve.strength(relative(w)); }
  /// ∫f s dw from 0 to w (J/m2).
  [[nodiscard]] double work(double w) const { return fracture_energy * curve.area(relative(w)); }
  /// The same less the triangle ½ f s w below the secant, which unloading gives back (J/m2).
  [[nodiscard]] double work_less_secant(double w) const { return work(w) - 0.5 * strength * (1.0 - damage(w)) * w; }

  /// What the damage of the other mode, constant or its mean, takes from the growth of work() between w and a later w
  /// (J/m2).
  [[nodiscard]] double work_lost(double from, double to, DamageCoupling coupling, double other_damage) const {
    switch (coupling) {
      case DamageCoupling::sum:
        return capped_work(from, to, other_damage);
      case DamageCoupling::largest:
        return work(to) - work(from) - capped_work(from, to, 1.0 - other_damage);
      case DamageCoupling::none:
        break;
    }
    return 0.0;
  }

  /// Where the strength falls faster with w than the spring gives way, a contact snaps back. It does not if
  /// G >= c f² A/k, c the steepest slope of s(x).
  [[nodiscard]] std::optional<LawComplaint> complaint(const char* parameter, double flexibility) const {
    const double least = curve.steepest() * strength * strength * flexibility;
    if (fracture_energy >= least) return {};
    return LawComplaint{
        .severity = least / fracture_energy,
        .parameter = parameter,
        .text = fmt::format("'{}' is {:.4g} J/m2, but a contact needs at least {:.4g} J/m2, or it snaps "
                            "back: raise it, take smaller particles or law = \"mohr_coulomb_brittle\"",
                            parameter, fracture_energy, least)};
  }

 private:
  /// ∫f min(s, level) dw (J/m2).
  [[nodiscard]] double capped_work(double from, double to, double level) const {
    const double kink = std::clamp(curve.opening_at(level) * fracture_energy / strength, from, to);
    return strength * level * (kink - from) + work(to) - work(kink);
  }
  [[nodiscard]] double solve(double a, double r, DamageCoupling coupling, double other_damage) const {
    switch (coupling) {
      case DamageCoupling::sum:
        return std::min(curve.intersection(a, r + a * other_damage), curve.opening_at(other_damage));
      case DamageCoupling::largest:
        // Where the other damage is the larger one the strength is constant.
        return std::clamp(r - a * (1.0 - other_damage), curve.intersection(a, r), curve.end());
      case DamageCoupling::none:
        break;
    }
    return curve.intersection(a, r);
  }
};

}  // namespace ligament
