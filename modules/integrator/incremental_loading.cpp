#include "integrator/incremental_loading.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/increment_work.hpp"
#include "integrator/ledger_lines.hpp"

namespace ligament {
namespace {

/// An increment that does not settle is tried again with this share of it.
constexpr double cut = 0.3;

void remember_direction(const Increment& increment, double step, LoadingState& loading) {
  loading.direction = increment.motion();
  for (std::size_t i = 0; i < loading.direction.size(); ++i) loading.direction[i] *= increment.free()[i];
  loading.direction_step = step;
}

}  // namespace

void IncrementalLoading::declare(Parameters& parameters) {
  parameters
      .quantity("increment", increment_, "m", "displacement of the fastest [[motion]] from one equilibrium to the next")
      .greater_than(0.0)
      .required();
  if (search_->follows_gauges()) {
    parameters.text(
        "control", control_,
        "name of a gauge of displacements or openings: 'increment' is then of this gauge, and the [[motion]] "
        "that drives it goes forth or back as the gauge asks for; it ends with its stage as ever");
  }
  parameters
      .integer("load_steps", load_steps_,
               "increments from one corner of the loading to the next where nothing is moved: loads change, or hold")
      .at_least(1);
  criterion_.declare(parameters);
  parameters
      .number("smallest_share", smallest_share_,
              "the run ends when an increment cut to less than this share of itself finds no equilibrium")
      .greater_than(0.0)
      .at_most(1.0);
  search_->declare(parameters);
}

void IncrementalLoading::set_loading(std::vector<PrescribedFreedom> freedoms, std::vector<std::vector<double>> corners,
                                     double unbalanced_ratio) {
  freedoms_ = std::move(freedoms);
  corners_ = std::move(corners);
  criterion_.unbalanced_ratio = unbalanced_ratio;
}

void IncrementalLoading::open_lines(EnergyLedger& ledger) {
  for (const char* line : {ledger_lines::prescribed_motions, ledger_lines::applied_loads, released_line}) {
    ledger.open(line);
  }
}

bool IncrementalLoading::advance(const Model& model, State& state, const ForceEvaluation& evaluation) {
  Increment increment(model, state, evaluation, criterion_, freedoms_);
  const Segment segment = segment_at(state);
  IncrementTarget target = wanted_target(state);
  const bool is_gauged = !target.gauge.empty();
  double wanted = target.step;
  // After a cut the way back to the wanted increment is taken in strides.
  if (state.loading.step > 0.0) target.step = std::min(wanted, 2.0 * state.loading.step);
  if (search_->extrapolates() && state.loading.direction.empty()) find_direction(increment, wanted);
  for (;;) {
    if (find(increment, target)) break;
    increment.restore();
    if (evaluation.is_interrupted()) return false;
    if (cut * target.step > smallest_share_ * wanted) {
      target.step *= cut;
      continue;
    }
    if (!target.gauge.empty()) {
      // Where the gauge cannot be followed the motions go on by time.
      target = {.step = target.usual_time};
      wanted = target.step;
      continue;
    }
    increment.go_live();
    if (search_->find_live(increment, target.step)) break;
    increment.restore();
    return false;
  }
  if (is_gauged && target.gauge.empty()) ++state.loading.n_without_control;
  accept(increment);
  // What is of time is no measure for the next increment of a gauge.
  state.loading.step = is_gauged && target.gauge.empty() ? 0.0 : target.step;
  // Beyond a corner everything moves another way.
  if (segment_at(state).begin > segment.begin) begin_segment(state);
  return true;
}

void IncrementalLoading::find_direction(Increment& increment, double wanted) {
  // A platen that starts at full increment would hit what it touches: most of its work would go to relaxation, and
  // contacts that bounce off have no work that a trapezoid could find.
  const double step = 1e-3 * wanted;
  increment.observe(false);
  if (search_->find(increment, {.step = step})) remember_direction(increment, step, increment.state().loading);
  increment.restore();
  increment.observe(true);
}

IncrementalLoading::Segment IncrementalLoading::segment_at(const State& state) const {
  const std::vector<double>& corners = corners_[state.stage.number - 1];
  const double time = state.clock.time - state.stage.begin_time;
  // An increment ends at a corner to rounding.
  constexpr double rounding = 1e-12;
  Segment segment;
  for (const double corner : corners) {
    segment.begin = segment.end;
    segment.end = corner;
    if (time < (1.0 - rounding) * corner) return segment;
  }
  return {segment.end, segment.end};
}

bool IncrementalLoading::find(Increment& increment, const IncrementTarget& target) {
  const double left = time_left(increment.state());
  if (!search_->find(increment, target)) return false;
  // Where a segment of the loading ends, it ends by its time.
  if (target.gauge.empty() || increment.state().clock.time - increment.start_time() <= left) return true;
  increment.restore();
  return search_->find(increment, {.step = left});
}

void IncrementalLoading::begin_segment(State& state) {
  state.loading.direction.clear();
  state.loading.older_direction.clear();
  state.loading.gauge_sign = 0.0;
  // The remainder before a corner was no cut.
  state.loading.step = 0.0;
}

double IncrementalLoading::time_left(const State& state) const {
  return segment_at(state).end - (state.clock.time - state.stage.begin_time);
}

IncrementTarget IncrementalLoading::wanted_target(const State& state) const {
  const Segment segment = segment_at(state);
  const double left = time_left(state);
  double step = (segment.end - segment.begin) / static_cast<double>(load_steps_);
  double fastest = 0.0;
  for (const PrescribedFreedom& freedom : freedoms_) {
    // Velocities are linear between corners.
    for (const double share : {1e-9, 1.0 - 1e-9}) {
      const double time = state.clock.time + share * left;
      fastest = std::max(fastest, std::abs(prescribed_velocity(freedom, state.stage, time, 0.0)));
    }
  }
  if (fastest > 0.0) step = increment_ / fastest;
  if (fastest > 0.0 && !gauge_.empty())
    return {.step = increment_, .gauge = gauge_, .usual_time = std::min(step, left)};
  // A remainder that rounding leaves is no increment of its own.
  return {.step = step > (1.0 - 1e-9) * left ? left : step};
}

void IncrementalLoading::accept(Increment& increment) {
  State& state = increment.state();
  LoadingState& loading = state.loading;
  const bool is_smooth = increment.n_evaluations() <= search_->most_evaluations_of_smooth_increment();
  const double step = state.clock.time - increment.start_time();
  if (increment.n_evaluations() <= search_->most_evaluations_of_steady_increment()) {
    loading.older_direction.clear();
  } else {
    loading.older_direction = std::move(loading.direction);
    loading.older_step = loading.direction_step;
  }
  remember_direction(increment, step, loading);
  // A bond that breaks on the way of a jump is a narrow peak, which few intervals may step over.
  book_increment_work(increment, is_smooth ? 2 : 64);
  loading.peak_force = std::max(loading.peak_force, increment.through_force());
  loading.n_evaluations += increment.n_evaluations();
  ++state.clock.step;
}

std::vector<EnergyTerm> IncrementalLoading::energies(const Model& /*model*/, const State& state) const {
  return {{released_line, EnergyKind::dissipated, state.ledger.total(released_line)}};
}

}  // namespace ligament
