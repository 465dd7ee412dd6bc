#pragma once

#include <string>
#include <vector>

#include "core/contact_memory.hpp"
#include "core/contact_trial.hpp"
#include "core/model.hpp"
#include "core/state.hpp"
#include "core/stiffness_bounds.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {

/// Whatever has a line in the energy ledger.
class EnergySource {
 public:
  virtual ~EnergySource() = default;

  /// Its lines at time n, always the same ones in the same order.
  [[nodiscard]] virtual std::vector<EnergyTerm> energies(const Model& model, const State& state) const = 0;

  /// Books what is a sum over the path rather than a function of the state; velocities on both sides of n are known.
  virtual void book_work(const Model& /*model*/, State& /*state*/) {}
};

/// Magnitudes of internal forces, to measure unbalanced forces against.
struct ForceMagnitudes {
  double sum = 0.0;    ///< (N)
  double count = 0.0;  ///< of forces that are not zero

  ForceMagnitudes& operator+=(const ForceMagnitudes& b) {
    sum += b.sum;
    count += b.count;
    return *this;
  }
};

/// Adds forces and moments to the bodies: contacts, elements, loads, gravity.
class ForceProvider : public EnergySource {
 public:
  /// Adds the forces of time n, Eqs (3)-(28), to State::…::force; history moves from n-1 to n.
  virtual void add_forces(const Model& model, State& state) = 0;

  /// Whether these are loads that the case applies, whose work is a sum over the path.
  [[nodiscard]] virtual bool is_applied_load() const { return false; }

  /// Adds its rows to the Gershgorin bound; forces without stiffness add nothing.
  virtual void add_stiffness(const Model& /*model*/, const State& /*state*/, StiffnessBounds& /*bounds*/) const {}

  /// Adds its stiffness about the state, springs without stiffness for contacts that do not touch; forces without
  /// stiffness add nothing.
  virtual void assemble(const Model& /*model*/, const State& /*state*/, StiffnessSum& /*stiffness*/) const {}

  /// Adds the stiffness (N/m) with which each of its springs, in the order of assemble(), would carry the force it has,
  /// from where it has none, `before` being what contacts remember. It lies between 0 and the elastic one.
  virtual void add_secants(const Model& /*model*/, const State& /*state*/, const ContactMemory& /*before*/,
                           std::vector<double>& /*stiffness*/) const {}

  /// How many springs assemble() adds.
  [[nodiscard]] virtual std::size_t n_springs(const Model& /*model*/, const State& /*state*/) const { return 0; }

  /// Adds its contacts whose bonds are not whole; its springs are numbered from `first_spring` on.
  virtual void add_loose_contacts(const State& /*state*/, const ContactMemory& /*before*/, std::size_t /*first_spring*/,
                                  std::vector<LooseContact>& /*loose*/) const {}

  /// What one of them, named by its normal spring among those of this provider, would answer to a stretch since
  /// `before`.
  [[nodiscard]] virtual SpringAnswer try_contact(const Model& /*model*/, const State& /*state*/,
                                                 const ContactMemory& /*before*/, std::size_t /*spring*/,
                                                 const SpringPair& /*stretch*/) const {
    return {};
  }

  /// The forces that say how large an unbalanced force is: those of contacts; those of elements where there are no
  /// particles.
  [[nodiscard]] virtual ForceMagnitudes internal_forces(const Model& /*model*/, const State& /*state*/) const {
    return {};
  }
};

}  // namespace ligament
