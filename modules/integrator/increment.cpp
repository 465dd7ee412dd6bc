#include "integrator/increment.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/parameters.hpp"
#include "integrator/convergence.hpp"
#include "integrator/freedom_columns.hpp"

namespace ligament {
namespace {

Vector sum_of_free(const TranslationState& bodies, const Field<Vector>& free) {
  return block_sum(bodies.force.size(), [&](std::size_t i) { return componentwise(free[i], bodies.force[i]); });
}

Index number_of(const FreedomNumbers& numbers, const PrescribedFreedom& freedom) {
  if (freedom.axis == dimension) return numbers.rotation(freedom.row);
  return freedom.body == PrescribedFreedom::Body::node ? numbers.node(freedom.row, freedom.axis)
                                                       : numbers.particle(freedom.row, freedom.axis);
}

}  // namespace

void EquilibriumCriterion::declare(Parameters& parameters) {
  parameters
      .number("force_mismatch", force_mismatch,
              "equilibrium: what external forces lack to balance, over the largest one so far, is at most this")
      .greater_than(0.0);
  parameters
      .integer("settled_evaluations", settled_evaluations,
               "equilibrium: successive evaluations of the forces in which both hold")
      .at_least(1);
  parameters.integer("most_evaluations", most_evaluations, "an increment that takes more is cut to a smaller one")
      .at_least(10);
}

Increment::Increment(const Model& model, State& state, const ForceEvaluation& evaluation,
                     const EquilibriumCriterion& criterion, const std::vector<PrescribedFreedom>& freedoms)
    : model_(model),
      state_(state),
      evaluation_(evaluation),
      criterion_(criterion),
      freedoms_(freedoms),
      free_(free_mask(model)) {
  state.particles.translation.increment.assign(model.particles.size(), Vector{});
  state.particles.rotation.increment.assign(model.particles.size(), 0.0);
  state.nodes.translation.increment.assign(model.nodes.size(), Vector{});
  start_.time = state.clock.time;
  start_.contacts.take(state);
  start_.particles = state.particles;
  start_.nodes = state.nodes;
  start_.forces = all_forces(model, state);
  start_.loads = applied_loads();
}

void Increment::restore() {
  state_.clock.time = start_.time;
  start_.contacts.put_back(state_);
  state_.particles = start_.particles;
  state_.nodes = start_.nodes;
}

void Increment::begin() {
  n_evaluations_ = 0;
  n_settled_ = 0;
}

void Increment::go_to(double step) {
  state_.clock.time = start_.time + step;
  loads_ = applied_loads();
}

void Increment::move(const std::vector<double>& motion) {
  move_bodies(motion, state_);
  start_.contacts.put_back(state_);
  evaluation_.add_forces();
  forces_ = all_forces(model_, state_);
  ++n_evaluations_;
}

void Increment::go_along(const std::vector<double>& motion, double end_time, double share) {
  state_.particles = start_.particles;
  state_.nodes = start_.nodes;
  state_.clock.time = start_.time + share * (end_time - start_.time);
  std::vector<double> part(motion);
  for (double& value : part) value *= share;
  loads_ = applied_loads();
  move(part);
}

bool Increment::has_settled() {
  n_settled_ = is_in_equilibrium() ? n_settled_ + 1 : 0;
  return n_settled_ >= criterion_.settled_evaluations;
}

bool Increment::is_exhausted() const {
  return n_evaluations_ >= criterion_.most_evaluations || evaluation_.is_interrupted();
}

std::vector<double> Increment::applied_loads() {
  const ParticleState particles = state_.particles;
  const NodeState nodes = state_.nodes;
  evaluation_.add_applied_loads();
  std::vector<double> loads = all_forces(model_, state_);
  state_.particles = particles;
  state_.nodes = nodes;
  return loads;
}

std::vector<double> Increment::prescribed_motion(double step) const {
  const FreedomNumbers numbers(model_);
  std::vector<double> motion(numbers.count(), 0.0);
  const double middle = start_.time + 0.5 * step;
  for (const PrescribedFreedom& freedom : freedoms_) {
    motion[number_of(numbers, freedom)] = step * prescribed_velocity(freedom, state_.stage, middle);
  }
  return motion;
}

bool Increment::is_in_equilibrium() {
  // Internal forces balance each other, so that what free bodies lack is what external forces lack.
  const Vector lacking = sum_of_free(state_.particles.translation, model_.particles.free) +
                         sum_of_free(state_.nodes.translation, model_.nodes.free);
  through_force_ = 0.5 * block_sum(forces_.size(), [&](std::size_t i) {
                     return (1.0 - free_[i]) * std::abs(forces_[i] - loads_[i]) + std::abs(loads_[i]);
                   });
  const double peak = std::max(state_.loading.peak_force, through_force_);
  if (!(norm(lacking) <= criterion_.force_mismatch * peak)) return false;
  const Unbalance unbalance = measure_unbalance(model_, state_, evaluation_.internal());
  // What has come apart carries hardly any force to compare with.
  return unbalance.largest_resultant <=
         criterion_.unbalanced_ratio * std::max(unbalance.mean_force, criterion_.force_mismatch * peak);
}

}  // namespace ligament
