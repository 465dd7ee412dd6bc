#pragma once

#include "core/force_provider.hpp"

namespace ligament {

/// Keeps the contact tables of the state in step with the motion. Its lines of the ledger are what dropped contacts had
/// stored or spent.
class ContactDetector : public EnergySource {
 public:
  /// Bonds all pairs within the detection gaps of their zones: fills the pairs of set-up of the model and the contact
  /// tables of the state.
  virtual void bond(Model& model, State& state) = 0;

  /// Finds new contacts and drops old ones if bodies have moved far enough for it; true if it did.
  virtual bool update(const Model& model, State& state) = 0;

  /// How far every body can still go (m) before an update could do anything; 0 where that is not known.
  [[nodiscard]] virtual double spare_travel(const Model& /*model*/, const State& /*state*/) const { return 0.0; }
};

}  // namespace ligament
