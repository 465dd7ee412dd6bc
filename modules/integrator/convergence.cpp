#include "integrator/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>


namespace ligament {
namespace {

double largest_resultant(const TranslationState& bodies, const Field<Vector>& free) {
  double largest = 0.0;
  for (std::size_t i = 0; i < bodies.force.size(); ++i) {
    const double resultant = norm(componentwise(free[i], bodies.force[i]));
    // Written so that a force that is not a number counts as infinite.
    if (!(resultant <= largest)) largest = resultant;
  }
  return largest;
}

double largest_moment(const Model& model, const RotationState& bodies) {
  double largest = 0.0;
  for (std::size_t i = 0; i < bodies.moment.size(); ++i) {
    const double resultant = std::abs(model.particles.rotation_free[i] * bodies.moment[i]) / model.particles.radius[i];
    if (!(resultant <= largest)) largest = resultant;
  }
  return largest;
}

}  // namespace

double Unbalance::ratio() const {
  return mean_force > 0.0 ? largest_resultant / mean_force : std::numeric_limits<double>::infinity();
}

Unbalance measure_unbalance(const Model& model, const State& state, const ForceMagnitudes& internal_forces) {
  return {std::max({largest_resultant(state.particles.translation, model.particles.free),
                    largest_resultant(state.nodes.translation, model.nodes.free),
                    largest_moment(model, state.particles.rotation)}),
          internal_forces.count > 0.0 ? internal_forces.sum / internal_forces.count : 0.0};
}

}  // namespace ligament
