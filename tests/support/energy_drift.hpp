#pragma once

#include <algorithm>
#include <cmath>

#include "simulation.hpp"

namespace ligament::support {

/// Follows the balance of a simulation whose start was made by hand, so that the ledger knows nothing of the energy it
/// brought.
class EnergyDrift {
 public:
  explicit EnergyDrift(const Simulation& simulation) : start_(balance(simulation).defect()) {}

  /// Defect since the start over the largest energy or work so far.
  double measure(const Simulation& simulation) {
    const EnergyBalance now = balance(simulation);
    scale_ = std::max({scale_, std::abs(now.kinetic), now.elastic, std::abs(now.work), std::abs(start_)});
    largest_ = std::max(largest_, std::abs(now.defect() - start_) / scale_);
    return largest_;
  }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  static EnergyBalance balance(const Simulation& simulation) {
    EnergyBalance sum;
    for (const EnergyTerm& term : simulation.energies()) sum.add(term);
    return sum;
  }

  double start_;
  double scale_ = 0.0;
  double largest_ = 0.0;
};

}  // namespace ligament::support
