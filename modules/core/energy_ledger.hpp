#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

/// Energy of a path, such as the work of damping, summed with compensation. By the identity of the central differences
/// a force F(n) works over half of the displacement on either side of n: the half behind is booked at once, the half
/// ahead waits until the step is taken.
struct PathSum {
  double value = 0.0;         ///< up to time n (J)
  double compensation = 0.0;  ///< Neumaier's correction (J)
  double pending = 0.0;       ///< ½ F(n)·v(n+½)Δt (J)

  /// Closes the step n-1 → n with ½ F(n)·v(n-½)Δt and opens the next one.
  void book(double half_behind, double half_ahead) {
    add(pending);
    add(half_behind);
    pending = half_ahead;
  }
  void add(double term) {
    const double sum = value + term;
    const bool value_is_larger = (value < 0.0 ? -value : value) >= (term < 0.0 ? -term : term);
    compensation += value_is_larger ? (value - sum) + term : (term - sum) + value;
    value = sum;
  }
  [[nodiscard]] double total() const { return value + compensation; }
};

/// Which side of the balance a term stands on.
enum class EnergyKind {
  kinetic,     ///< of motion
  elastic,     ///< stored
  dissipated,  ///< spent for good
  work,        ///< brought in from outside
};

/// One line of the ledger (J).
struct EnergyTerm {
  std::string name;
  EnergyKind kind = EnergyKind::work;
  double value = 0.0;
};

/// The balance of all terms at one time.
struct EnergyBalance {
  double kinetic = 0.0;
  double elastic = 0.0;
  double dissipated = 0.0;
  double work = 0.0;

  void add(const EnergyTerm& term);
  /// Energy found less energy brought in (J); zero when the ledger closes.
  [[nodiscard]] double defect() const { return kinetic + elastic + dissipated - work; }
};

/// The sums of the run that are not functions of the state at one time.
struct EnergyLedger {
  std::vector<std::string> names;  ///< of the path sums
  Field<PathSum> sums;
  double scale = 0.0;          ///< running maximum of |work|, elastic and kinetic energy at the audited times (J)
  double largest_error = 0.0;  ///< running maximum of |defect| / scale

  /// The row of the path sum with this name, opened if it is new.
  Index open(std::string_view name);
  /// The path sum with this name (J), 0 if there is none.
  [[nodiscard]] double total(std::string_view name) const;
  PathSum& operator[](Index row) { return sums[static_cast<std::size_t>(row)]; }
  const PathSum& operator[](Index row) const { return sums[static_cast<std::size_t>(row)]; }

  /// Takes a balance into the running maxima; returns its error, 0 while nothing has happened, infinite if
  /// an energy is not finite.
  double audit(const EnergyBalance& balance);
};

}  // namespace ligament
