#include "integrator/incremental_loading.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/increment_work.hpp"
#include "integrator/ledger_lines.hpp"

namespace ligament {
namespace {

/// Most of what may be extrapolated: an increment that took more evaluations held a jump, which will not come again.
constexpr std::int64_t most_evaluations_of_smooth_increment = 150;

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
  const double wanted = wanted_step(state);
  // After a cut the way back to the wanted increment is taken in strides.
  double step = state.loading.step > 0.0 ? std::min(wanted, 2.0 * state.loading.step) : wanted;
  if (search_->extrapolates() && state.loading.direction.empty()) find_direction(increment, wanted);
  for (;;) {
    if (search_->find(increment, step)) break;
    increment.restore();
    if (evaluation.is_interrupted()) return false;
    if (cut * step > smallest_share_ * wanted) {
      step *= cut;
      continue;
    }
    increment.go_live();
    if (search_->find_live(increment, step)) break;
    increment.restore();
    return false;
  }
  accept(increment, step);
  // Beyond a corner everything moves another way.
  if (segment_at(state).begin != segment.begin) state.loading.direction.clear();
  return true;
}

void IncrementalLoading::find_direction(Increment& increment, double wanted) {
  // A platen that starts at full increment would hit what it touches: most of its work would go to relaxation, and
  // contacts that bounce off have no work that a trapezoid could find.
  const double step = 1e-3 * wanted;
  increment.observe_by({});
  if (search_->find(increment, step)) remember_direction(increment, step, increment.state().loading);
  increment.restore();
  increment.observe_by(increment.evaluation().observer);
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

double IncrementalLoading::wanted_step(const State& state) const {
  const Segment segment = segment_at(state);
  const double left = segment.end - (state.clock.time - state.stage.begin_time);
  double step = (segment.end - segment.begin) / static_cast<double>(load_steps_);
  double fastest = 0.0;
  for (const PrescribedFreedom& freedom : freedoms_) {
    // Velocities are linear between corners.
    for (const double share : {1e-9, 1.0 - 1e-9}) {
      const double time = state.clock.time + share * left;
      fastest = std::max(fastest, std::abs(prescribed_velocity(freedom, state.stage, time, time)));
    }
  }
  if (fastest > 0.0) step = increment_ / fastest;
  // A remainder that rounding leaves is no increment of its own.
  return step > (1.0 - 1e-9) * left ? left : step;
}

void IncrementalLoading::accept(Increment& increment, double step) {
  State& state = increment.state();
  LoadingState& loading = state.loading;
  const bool is_smooth = increment.n_evaluations() <= most_evaluations_of_smooth_increment;
  if (loading.direction.empty() || is_smooth) remember_direction(increment, step, loading);
  // A bond that breaks on the way of a jump is a narrow peak, which few intervals may step over.
  book_increment_work(increment, is_smooth ? 2 : 64);
  loading.step = step;
  loading.peak_force = std::max(loading.peak_force, increment.through_force());
  loading.n_evaluations += increment.n_evaluations();
  ++state.clock.step;
}

std::vector<EnergyTerm> IncrementalLoading::energies(const Model& /*model*/, const State& state) const {
  return {{released_line, EnergyKind::dissipated, state.ledger.total(released_line)}};
}

}  // namespace ligament
