#include "integrator/incremental_loading.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/parameters.hpp"
#include "integrator/convergence.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/ledger_lines.hpp"
#include "integrator/line_integral.hpp"

namespace ligament {
namespace {

constexpr const char* released_line = "released";

Vector sum_of_free(const TranslationState& bodies, const Field<Vector>& free) {
  return block_sum(bodies.force.size(), [&](std::size_t i) { return componentwise(free[i], bodies.force[i]); });
}

Index number_of(const FreedomNumbers& numbers, const PrescribedFreedom& freedom) {
  if (freedom.axis == dimension) return numbers.rotation(freedom.row);
  return freedom.body == PrescribedFreedom::Body::node ? numbers.node(freedom.row, freedom.axis)
                                                       : numbers.particle(freedom.row, freedom.axis);
}

/// Most of what may be extrapolated: an increment that took more evaluations held a jump, which will not come again.
constexpr std::int64_t most_evaluations_of_smooth_increment = 150;

/// An increment that does not settle is tried again with this share of it.
constexpr double cut = 0.3;

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
  parameters
      .number("force_mismatch", force_mismatch_,
              "equilibrium: what external forces lack to balance, over the largest one so far, is at most this")
      .greater_than(0.0);
  parameters
      .integer("settled_evaluations", settled_evaluations_,
               "equilibrium: successive evaluations of the forces in which both hold")
      .at_least(1);
  parameters.integer("most_evaluations", most_evaluations_, "an increment that takes more is cut to a smaller one")
      .at_least(10);
  parameters
      .number("smallest_share", smallest_share_,
              "the run ends when an increment cut to less than this share of itself finds no equilibrium")
      .greater_than(0.0)
      .at_most(1.0);
  bounds_.declare(parameters);
  parameters
      .quantity("coarse_cell", coarse_cell_, "m",
                "size of the cells of the coarse motions; default half of the shorter side of the structure")
      .greater_than(0.0);
}

void IncrementalLoading::set_loading(std::vector<PrescribedFreedom> freedoms, std::vector<std::vector<double>> corners,
                                     double unbalanced_ratio) {
  freedoms_ = std::move(freedoms);
  corners_ = std::move(corners);
  unbalanced_ratio_ = unbalanced_ratio;
}

void IncrementalLoading::use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
  bounds_.check();
  mass_.emplace(model, state, stiffness, coarse_cell_);
  free_ = free_mask(model);
}

void IncrementalLoading::open_lines(EnergyLedger& ledger) {
  for (const char* line : {ledger_lines::prescribed_motions, ledger_lines::applied_loads, released_line}) {
    ledger.open(line);
  }
}

bool IncrementalLoading::advance(const Model& model, State& state, const ForceEvaluation& evaluation) {
  begin(model, state, evaluation);
  const Segment segment = segment_at(state);
  const double wanted = wanted_step(state);
  // After a cut the way back to the wanted increment is taken in strides.
  double step = state.loading.step > 0.0 ? std::min(wanted, 2.0 * state.loading.step) : wanted;
  if (state.loading.direction.empty()) find_direction(model, state, evaluation, wanted);
  for (;;) {
    if (relax(model, state, evaluation, step)) {
      accept(model, state, evaluation, step);
      // Beyond a corner everything moves another way, and the remainder before it was no cut.
      if (segment_at(state).begin != segment.begin) {
        state.loading.direction.clear();
        state.loading.step = 0.0;
      }
      return true;
    }
    restore(state);
    step *= cut;
    if (!(step > smallest_share_ * wanted) || evaluation.is_interrupted()) return false;
  }
}

void IncrementalLoading::find_direction(const Model& model, State& state, const ForceEvaluation& evaluation,
                                        double wanted) {
  // A platen that starts at full increment would hit what it touches: most of its work would go to relaxation, and
  // contacts that bounce off have no work that a trapezoid could find.
  const double step = 1e-3 * wanted;
  ForceEvaluation unobserved = evaluation;
  unobserved.observe_every = 0;
  if (relax(model, state, unobserved, step)) remember_direction(model, state, step);
  restore(state);
}

void IncrementalLoading::remember_direction(const Model& model, State& state, double step) const {
  LoadingState& loading = state.loading;
  loading.direction = all_increments(model, state);
  for (std::size_t i = 0; i < free_.size(); ++i) loading.direction[i] *= free_[i];
  loading.direction_step = step;
}

void IncrementalLoading::begin(const Model& model, State& state, const ForceEvaluation& evaluation) {
  state.particles.translation.increment.assign(model.particles.size(), Vector{});
  state.particles.rotation.increment.assign(model.particles.size(), 0.0);
  state.nodes.translation.increment.assign(model.nodes.size(), Vector{});
  start_.time = state.clock.time;
  start_.contacts.take(state);
  start_.particles = state.particles;
  start_.nodes = state.nodes;
  start_.forces = all_forces(model, state);
  start_.loads = applied_loads(model, state, evaluation);
}

void IncrementalLoading::restore(State& state) const {
  state.clock.time = start_.time;
  start_.contacts.put_back(state);
  state.particles = start_.particles;
  state.nodes = start_.nodes;
}

std::vector<double> IncrementalLoading::applied_loads(const Model& model, State& state,
                                                      const ForceEvaluation& evaluation) {
  const ParticleState particles = state.particles;
  const NodeState nodes = state.nodes;
  evaluation.add_applied_loads();
  std::vector<double> loads = all_forces(model, state);
  state.particles = particles;
  state.nodes = nodes;
  return loads;
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
      fastest = std::max(fastest, std::abs(prescribed_velocity(freedom, state.stage, time, 0.0)));
    }
  }
  if (fastest > 0.0) step = increment_ / fastest;
  // A remainder that rounding leaves is no increment of its own.
  return step > (1.0 - 1e-9) * left ? left : step;
}

bool IncrementalLoading::relax(const Model& model, State& state, const ForceEvaluation& evaluation, double step) {
  const LoadingState& loading = state.loading;
  n_evaluations_ = 0;
  state.clock.time = start_.time + step;
  loads_ = applied_loads(model, state, evaluation);

  std::vector<double> motion = prescribed_motion(model, state, step);
  if (!loading.direction.empty() && loading.direction_step > 0.0) {
    const double scale = step / loading.direction_step;
    for (std::size_t i = 0; i < motion.size(); ++i) motion[i] += scale * loading.direction[i];
  }
  move(model, state, evaluation, motion);

  std::vector<double> momenta(motion.size(), 0.0);
  std::vector<double> free_before = free_forces(model, state);
  std::vector<double> free_now = free_before;
  // At rest the first half of the step has no time to act.
  double damping = 2.0;
  std::int64_t n_settled = 0;
  while (n_settled < settled_evaluations_) {
    if (n_evaluations_ >= most_evaluations_ || evaluation.is_interrupted()) return false;
    update_momenta(momenta, free_now, damping);
    motion = mass_->velocities(momenta);
    move(model, state, evaluation, motion);
    if (evaluation.observe_every > 0 && n_evaluations_ % evaluation.observe_every == 0) {
      evaluation.observe(n_evaluations_, 0.5 * product(motion, momenta));
    }
    free_before = std::move(free_now);
    free_now = free_forces(model, state);
    damping = adaptive_damping(motion, momenta, free_now, free_before, bounds_);
    n_settled = is_settled(model, state, evaluation) ? n_settled + 1 : 0;
  }
  return true;
}

void IncrementalLoading::move(const Model& model, State& state, const ForceEvaluation& evaluation,
                              const std::vector<double>& motion) {
  move_bodies(motion, state);
  start_.contacts.put_back(state);
  evaluation.add_forces();
  forces_ = all_forces(model, state);
  ++n_evaluations_;
}

std::vector<double> IncrementalLoading::prescribed_motion(const Model& model, const State& state, double step) const {
  const FreedomNumbers numbers(model);
  std::vector<double> motion(numbers.count(), 0.0);
  for (const PrescribedFreedom& freedom : freedoms_) {
    const double velocity = prescribed_velocity(freedom, state.stage, start_.time, step);
    motion[number_of(numbers, freedom)] = step * velocity;
  }
  return motion;
}

bool IncrementalLoading::is_settled(const Model& model, const State& state, const ForceEvaluation& evaluation) {
  // Internal forces balance each other, so that what free bodies lack is what external forces lack.
  const Vector lacking = sum_of_free(state.particles.translation, model.particles.free) +
                         sum_of_free(state.nodes.translation, model.nodes.free);
  through_force_ = 0.5 * block_sum(forces_.size(), [&](std::size_t i) {
                     return (1.0 - free_[i]) * std::abs(forces_[i] - loads_[i]) + std::abs(loads_[i]);
                   });
  const double peak = std::max(state.loading.peak_force, through_force_);
  if (!(norm(lacking) <= force_mismatch_ * peak)) return false;
  const Unbalance unbalance = measure_unbalance(model, state, evaluation.internal());
  // What has come apart carries hardly any force to compare with.
  return unbalance.largest_resultant <= unbalanced_ratio_ * std::max(unbalance.mean_force, force_mismatch_ * peak);
}

void IncrementalLoading::accept(const Model& model, State& state, const ForceEvaluation& evaluation, double step) {
  LoadingState& loading = state.loading;
  const bool is_smooth = n_evaluations_ <= most_evaluations_of_smooth_increment;
  if (loading.direction.empty() || is_smooth) remember_direction(model, state, step);
  const std::vector<double> motion = all_increments(model, state);
  // Along states of equilibrium: the trapezoid, as of a load-displacement curve.
  const Work along_equilibria = 0.5 * (rate(motion, start_.forces, start_.loads) + rate(motion, forces_, loads_));
  book(along_equilibria, line_work(model, state, evaluation, motion, is_smooth), state.ledger);
  loading.step = step;
  loading.peak_force = std::max(loading.peak_force, through_force_);
  loading.n_evaluations += n_evaluations_;
  ++state.clock.step;
}

IncrementalLoading::Work& IncrementalLoading::Work::operator+=(const Work& b) {
  of_all += b.of_all;
  of_free += b.of_free;
  of_loads += b.of_loads;
  return *this;
}

IncrementalLoading::Work IncrementalLoading::rate(const std::vector<double>& motion, const std::vector<double>& forces,
                                                  const std::vector<double>& loads) const {
  return block_sum(motion.size(), [&](std::size_t i) {
    const double all = forces[i] * motion[i];
    return Work{all, free_[i] * all, free_[i] * loads[i] * motion[i]};
  });
}

IncrementalLoading::Work IncrementalLoading::line_work(const Model& model, State& state,
                                                       const ForceEvaluation& evaluation,
                                                       const std::vector<double>& motion, bool is_smooth) {
  const double time = state.clock.time;
  const ParticleState particles = state.particles;
  const NodeState nodes = state.nodes;
  ContactMemory contacts;
  contacts.take(state);
  const auto rate_at = [&](double share) {
    state.particles = start_.particles;
    state.nodes = start_.nodes;
    state.clock.time = start_.time + share * (time - start_.time);
    std::vector<double> part(motion);
    for (double& value : part) value *= share;
    const std::vector<double> loads = applied_loads(model, state, evaluation);
    move(model, state, evaluation, part);
    return rate(motion, forces_, loads);
  };
  const Work begin = rate(motion, start_.forces, start_.loads);
  const Work end = rate(motion, forces_, loads_);
  const double scale = std::abs(state.ledger.total(ledger_lines::prescribed_motions)) +
                       std::abs(state.ledger.total(ledger_lines::applied_loads)) + std::abs(end.of_prescribed()) +
                       std::abs(end.of_loads);
  constexpr double tolerance = 1e-6;
  // A bond that breaks on the way of a jump is a narrow peak, which few intervals may step over.
  const std::size_t fewest_intervals = is_smooth ? 2 : 64;
  // What counts is the work of internal forces, which contacts and elements store or spend.
  const auto internal = [](const Work& value) { return value.of_all - value.of_loads; };
  const Work work = line_integral(begin, end, rate_at, internal, fewest_intervals, tolerance * scale);
  state.clock.time = time;
  state.particles = particles;
  state.nodes = nodes;
  contacts.put_back(state);
  return work;
}

void IncrementalLoading::book(const Work& along_equilibria, const Work& along_line, EnergyLedger& ledger) {
  ledger[ledger.open(ledger_lines::prescribed_motions)].add(along_equilibria.of_prescribed());
  ledger[ledger.open(ledger_lines::applied_loads)].add(along_equilibria.of_loads);
  ledger[ledger.open(released_line)].add(along_line.of_free +
                                         (along_equilibria.of_prescribed() - along_line.of_prescribed()) +
                                         (along_equilibria.of_loads - along_line.of_loads));
}

std::vector<EnergyTerm> IncrementalLoading::energies(const Model& /*model*/, const State& state) const {
  return {{"released", EnergyKind::dissipated, state.ledger.total(released_line)}};
}

}  // namespace ligament
