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
  loading.direction = all_increments(increment.model(), increment.state());
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
  parameters.integer("load_steps", load_steps_, "increments of a stage in which loads rise and nothing is moved")
      .at_least(1);
  criterion_.declare(parameters);
  parameters
      .number("smallest_share", smallest_share_,
              "the run ends when an increment cut to less than this share of itself finds no equilibrium")
      .greater_than(0.0)
      .at_most(1.0);
  search_->declare(parameters);
}

void IncrementalLoading::set_loading(std::vector<PrescribedFreedom> freedoms, std::vector<double> ends,
                                     double unbalanced_ratio) {
  freedoms_ = std::move(freedoms);
  ends_ = std::move(ends);
  criterion_.unbalanced_ratio = unbalanced_ratio;
}

void IncrementalLoading::open_lines(EnergyLedger& ledger) {
  for (const char* line : {ledger_lines::prescribed_motions, ledger_lines::applied_loads, released_line}) {
    ledger.open(line);
  }
}

bool IncrementalLoading::advance(const Model& model, State& state, const ForceEvaluation& evaluation) {
  Increment increment(model, state, evaluation, criterion_, freedoms_);
  IncrementTarget target = wanted_target(state);
  const double wanted = target.step;
  // After a cut the way back to the wanted increment is taken in strides.
  if (state.loading.step > 0.0) target.step = std::min(wanted, 2.0 * state.loading.step);
  if (search_->extrapolates() && state.loading.direction.empty()) find_direction(increment, wanted);
  for (;;) {
    if (find(increment, target)) {
      accept(increment, target.step);
      return true;
    }
    increment.restore();
    target.step *= cut;
    if (!(target.step > smallest_share_ * wanted) || evaluation.is_interrupted()) return false;
  }
}

void IncrementalLoading::find_direction(Increment& increment, double wanted) {
  // A platen that starts at full increment would hit what it touches: most of its work would go to relaxation, and
  // contacts that bounce off have no work that a trapezoid could find.
  const double step = 1e-3 * wanted;
  if (search_->find(increment, {.step = step})) remember_direction(increment, step, increment.state().loading);
  increment.restore();
}

bool IncrementalLoading::find(Increment& increment, const IncrementTarget& target) {
  if (!search_->find(increment, target)) return false;
  // Where loading ends, it ends by its time.
  if (target.gauge.empty() || time_left(increment.state()) >= 0.0) return true;
  increment.restore();
  return search_->find(increment, {.step = time_left(increment.state())});
}

void IncrementalLoading::begin_stage(State& state) const {
  state.loading.direction.clear();
  if (gauge_.empty()) return;
  state.loading.gauge_sign = 0.0;
  state.loading.step = 0.0;
}

double IncrementalLoading::time_left(const State& state) const {
  return ends_[state.stage.number - 1] - (state.clock.time - state.stage.begin_time);
}

IncrementTarget IncrementalLoading::wanted_target(const State& state) const {
  const StageState& stage = state.stage;
  const double left = time_left(state);
  double step = ends_[stage.number - 1] / static_cast<double>(load_steps_);
  double fastest = 0.0;
  for (const PrescribedFreedom& freedom : freedoms_) {
    fastest = std::max(fastest, std::abs(prescribed_velocity(freedom, stage, state.clock.time + 1e-9 * left)));
  }
  if (fastest > 0.0) step = increment_ / fastest;
  if (fastest > 0.0 && !gauge_.empty())
    return {.step = increment_, .gauge = gauge_, .usual_time = std::min(step, left)};
  // A remainder that rounding leaves is no increment of its own.
  return {.step = step > (1.0 - 1e-9) * left ? left : step};
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
