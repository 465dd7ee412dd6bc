#pragma once

#include "core/force_provider.hpp"

namespace ligament {

/// How far the bodies are from equilibrium.
struct Unbalance {
  double largest_resultant = 0.0;  ///< over free bodies, moments over the radius included (N)
  double mean_force = 0.0;  ///< over contacts that carry force; over nodes of elements if there are no particles (N)

  /// The unbalanced force ratio; infinite while nothing carries force.
  [[nodiscard]] double ratio() const;
};

/// Over free bodies, moments over the radius included (N); infinite if one is not a number.
double largest_resultant(const Model& model, const State& state);

Unbalance measure_unbalance(const Model& model, const State& state, const ForceMagnitudes& internal_forces);

}  // namespace ligament
