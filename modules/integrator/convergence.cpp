#include "integrator/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligament {
namespace {

/// A force that is not a number counts as infinite.
template <class Magnitude>
double largest(std::size_t count, Magnitude&& magnitude) {
  double all = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = magnitude(i);
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    all = std::max(all, value);
  }
  return all;
}

double largest_resultant(const TranslationState& bodies, const Field<Vector>& free) {
  return largest(bodies.force.size(), [&](std::size_t i) { return norm(componentwise(free[i], bodies.force[i])); });
}

double largest_moment(const RotationState& bodies, const Field<double>& free, const Field<double>& lever) {
  return largest(bodies.moment.size(), [&](std::size_t i) { return std::abs(free[i] * bodies.moment[i]) / lever[i]; });
}

}  // namespace

double Unbalance::ratio() const {
  return mean_force > 0.0 ? largest_resultant / mean_force : std::numeric_limits<double>::infinity();
}

double largest_resultant(const Model& model, const State& state) {
  return std::max({largest_resultant(state.particles.translation, model.particles.free),
                   largest_resultant(state.nodes.translation, model.nodes.free),
                   largest_resultant(state.beam_nodes.translation, model.beam_nodes.free),
                   largest_moment(state.particles.rotation, model.particles.rotation_free, model.particles.radius),
                   largest_moment(state.beam_nodes.rotation, model.beam_nodes.rotation_free, model.beam_nodes.lever)});
}

Unbalance measure_unbalance(const Model& model, const State& state, const ForceMagnitudes& internal_forces) {
  return {largest_resultant(model, state),
          internal_forces.count > 0.0 ? internal_forces.sum / internal_forces.count : 0.0};
}

}  // namespace ligament
