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
  if (freedom.body == BodyTable::beam_node) return numbers.beam_node(freedom.row, freedom.axis);
  if (freedom.body == BodyTable::node) return numbers.node(freedom.row, freedom.axis);
  return numbers.particle(freedom.row, freedom.axis);
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
  parameters
      .integer(
          "most_live_evaluations", most_live_evaluations,
          "an increment cut as far as it may be lets contacts take their history along while it is relaxed; the run "
          "ends if that takes more; 0: it ends at once")
      .at_least(0);
}

Increment::Increment(const Model& model, State& state, const ForceEvaluation& evaluation,
                     const EquilibriumCriterion& criterion, const std::vector<PrescribedFreedom>& freedoms)
    : model_(model),
      state_(state),
      evaluation_(evaluation),
      criterion_(criterion),
      freedoms_(freedoms),
      free_(free_mask(model)) {
  clear_increments();
  start_.time = state.clock.time;
  start_.contacts.take(state);
  start_.bodies.take(state);
  start_.forces = all_forces(model, state);
  start_.loads = applied_loads();
}

void Increment::clear_increments() {
  state_.particles.translation.increment.assign(model_.particles.size(), Vector{});
  state_.particles.rotation.increment.assign(model_.particles.size(), 0.0);
  state_.nodes.translation.increment.assign(model_.nodes.size(), Vector{});
  state_.beam_nodes.translation.increment.assign(model_.beam_nodes.size(), Vector{});
  state_.beam_nodes.rotation.increment.assign(model_.beam_nodes.size(), 0.0);
}

void Increment::restore() {
  if (is_live()) {
    state_ = *std::move(before_);
    before_.reset();
    return;
  }
  state_.clock.time = start_.time;
  start_.contacts.put_back(state_);
  start_.bodies.put_back(state_);
}

void Increment::begin() {
  n_evaluations_ = 0;
  n_settled_ = 0;
}

void Increment::go_to(double step) {
  state_.clock.time = start_.time + step;
  loads_ = applied_loads();
  if (!is_live()) return;
  // Loads that come before anything moves do no work.
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i] = start_.forces[i] + (loads_[i] - start_.loads[i]);
}

void Increment::go_live() {
  before_ = state_;
  mean_force_before_ = mean_force();
  way_.assign(free_.size(), 0.0);
  work_on_the_way_ = {};
}

void Increment::move(const std::vector<double>& motion) {
  if (is_live()) return move_live(motion);
  move_bodies(motion, state_);
  start_.contacts.put_back(state_);
  evaluation_.add_forces();
  forces_ = all_forces(model_, state_);
  ++n_evaluations_;
}

void Increment::move_live(const std::vector<double>& motion) {
  clear_increments();
  move_bodies(motion, state_);
  evaluation_.update_contacts();
  evaluation_.add_forces();
  std::vector<double> mean = std::move(forces_);
  forces_ = all_forces(model_, state_);
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + forces_[i]);
  work_on_the_way_ += work_of(free_, motion, mean, loads_);
  for (std::size_t i = 0; i < way_.size(); ++i) way_[i] += motion[i];
  ++n_evaluations_;
}

std::vector<double> Increment::motion() const { return is_live() ? way_ : all_increments(model_, state_); }

void Increment::go_along(const std::vector<double>& motion, double end_time, double share) {
  start_.bodies.put_back(state_);
  state_.clock.time = start_.time + share * (end_time - start_.time);
  std::vector<double> part(motion);
  for (double& value : part) value *= share;
  loads_ = applied_loads();
  move(part);
}

void Increment::show(double kinetic_energy) const {
  const IncrementObserver& observer = evaluation_.observer;
  if (!is_observed_ || observer.every == 0 || n_evaluations_ % observer.every != 0) return;
  observer.look(n_evaluations_, kinetic_energy);
}

std::vector<double> Increment::free_forces() const {
  std::vector<double> forces(forces_.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = free_[i] * forces_[i];
  return forces;
}

bool Increment::has_settled() {
  // What lives takes thousands of evaluations.
  constexpr std::int64_t live_interval = 10;
  if (is_live() && n_evaluations_ % live_interval != 0) return false;
  n_settled_ = is_in_equilibrium() ? n_settled_ + 1 : 0;
  return n_settled_ >= criterion_.settled_evaluations;
}

bool Increment::is_exhausted() const {
  const std::int64_t most = is_live() ? criterion_.most_live_evaluations : criterion_.most_evaluations;
  return n_evaluations_ >= most || evaluation_.is_interrupted();
}

std::vector<double> Increment::applied_loads() {
  BodyMemory bodies;
  bodies.take(state_);
  evaluation_.add_applied_loads();
  std::vector<double> loads = all_forces(model_, state_);
  bodies.put_back(state_);
  return loads;
}

std::vector<double> Increment::prescribed_motion(double step) const {
  const FreedomNumbers numbers(model_);
  std::vector<double> motion(numbers.count(), 0.0);
  for (const PrescribedFreedom& freedom : freedoms_) {
    const double velocity = prescribed_velocity(freedom, state_.stage, start_.time, step);
    motion[number_of(numbers, freedom)] = step * velocity;
  }
  return motion;
}

bool Increment::is_in_equilibrium() {
  // Internal forces balance each other, so that what free bodies lack is what external forces lack.
  const Vector lacking = sum_of_free(state_.particles.translation, model_.particles.free) +
                         sum_of_free(state_.nodes.translation, model_.nodes.free) +
                         sum_of_free(state_.beam_nodes.translation, model_.beam_nodes.free);
  through_force_ = 0.5 * block_sum(forces_.size(), [&](std::size_t i) {
                     return (1.0 - free_[i]) * std::abs(forces_[i] - loads_[i]) + std::abs(loads_[i]);
                   });
  const double peak = std::max(state_.loading.peak_force, through_force_);
  if (!(norm(lacking) <= criterion_.force_mismatch * peak)) return false;
  return largest_resultant(model_, state_) <= force_tolerance();
}

double Increment::force_tolerance() const {
  // What has come apart carries hardly any force to compare with.
  const double least =
      is_live() ? mean_force_before_ : criterion_.force_mismatch * std::max(state_.loading.peak_force, through_force_);
  return criterion_.unbalanced_ratio * std::max(mean_force(), least);
}

double Increment::mean_force() const {
  const ForceMagnitudes internal = evaluation_.internal();
  return internal.count > 0.0 ? internal.sum / internal.count : 0.0;
}

}  // namespace ligament
