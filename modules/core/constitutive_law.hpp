#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

class Parameters;

/// Life of a contact. Unbonded ones touch without cohesion; a bond softens, then breaks, and stays with its law.
enum class BondState : std::uint8_t { unbonded, bonded, softening, broken };

/// The two ways in which a bond fails.
enum class FractureMode : std::uint8_t { none, tension, shear };

/// What a bond has lost of its strength.
struct ContactDamage {
  double value = 0.0;                      ///< 0 intact, 1 nothing left
  FractureMode mode = FractureMode::none;  ///< to which most of it is due
};

/// A number that a law keeps for each of its contacts. State holds one array per variable, so restart, hash, output and
/// comparison follow.
struct HistoryVariable {
  std::string name;
  std::string unit;
  double initial_value = 0.0;
};

/// A block of contacts of one law, in arrays of equal length. Kinematics are those of the step; forces, bond and
/// history enter as the contact last stored them and leave as the law returns them.
struct ContactBatch {
  std::span<const double> opening;              ///< u_n (m), > 0 apart, from the reference gap
  std::span<const ShearVector> slip_increment;  ///< Δu_s of the second body against the first (m)
  std::span<const double> normal_stiffness;     ///< k_n (N/m)
  std::span<const double> shear_stiffness;      ///< k_s (N/m)
  std::span<const double> area;                 ///< A = H t (m2)
  std::span<double> normal_force;               ///< F_n (N), > 0 in compression
  std::span<ShearVector> shear_force;           ///< F_s (N)
  std::span<BondState> bond;
  std::span<double* const> history;  ///< one array per variable, in the order of the law's declaration
};

/// The same contacts at rest, for what is a function of their state.
struct ContactBatchView {
  std::span<const double> opening;
  std::span<const double> normal_stiffness;
  std::span<const double> shear_stiffness;
  std::span<const double> area;
  std::span<const double> normal_force;
  std::span<const ShearVector> shear_force;
  std::span<const BondState> bond;
  std::span<const double* const> history;
};

/// Energies of contacts (J). Elastic parts are stored, the others spent.
struct ContactEnergies {
  double elastic_normal = 0.0;
  double elastic_shear = 0.0;
  double fracture_tension = 0.0;
  double fracture_shear = 0.0;
  double friction = 0.0;

  ContactEnergies& operator+=(const ContactEnergies& b) {
    elastic_normal += b.elastic_normal;
    elastic_shear += b.elastic_shear;
    fracture_tension += b.fracture_tension;
    fracture_shear += b.fracture_shear;
    friction += b.friction;
    return *this;
  }
  [[nodiscard]] double stored() const { return elastic_normal + elastic_shear; }
  [[nodiscard]] double spent() const { return fracture_tension + fracture_shear + friction; }
};

/// The springs and the area of one contact, without its state.
struct ContactSample {
  double normal_stiffness = 0.0;  ///< k_n (N/m)
  double shear_stiffness = 0.0;   ///< k_s (N/m)
  double area = 0.0;              ///< A (m2)
};

/// Why a law cannot serve a contact.
struct LawComplaint {
  double severity = 0.0;  ///< the larger, the worse: a case is told of the worst contact only
  std::string parameter;  ///< the one to blame
  std::string text;       ///< what is wrong with it, and what would do
};

/// Turns openings and slips into forces. It knows no geometry and keeps no numbers: parameters live here, history in
/// State. One virtual call serves a block of contacts.
class ConstitutiveLaw {
 public:
  virtual ~ConstitutiveLaw() = default;

  /// Its parameters, read from the table of the material that names it.
  virtual void declare(Parameters& parameters) = 0;

  [[nodiscard]] virtual std::vector<HistoryVariable> history() const = 0;

  /// The law of contacts without cohesion between the same bodies: those that form after set-up.
  [[nodiscard]] virtual std::unique_ptr<ConstitutiveLaw> contact_law() const = 0;

  /// What the law has against a contact made at set-up; by default nothing.
  [[nodiscard]] virtual std::optional<LawComplaint> complaint(const ContactSample& /*contact*/) const { return {}; }

  /// Forces at the end of the step, Eqs (19)-(24), history with them.
  virtual void evaluate(const ContactBatch& batch) const = 0;

  /// Stored and spent energy of the contacts, as functions of their state.
  [[nodiscard]] virtual ContactEnergies energies(const ContactBatchView& batch) const = 0;

  /// Damage of one contact from its history, in the order of the declaration; by default none.
  [[nodiscard]] virtual ContactDamage damage(std::span<const double> /*history*/) const { return {}; }
};

}  // namespace ligament
