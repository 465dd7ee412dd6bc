#include "integrator/secant_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"

namespace ligament {
namespace {

/// Of the largest resultant that equilibrium allows: from what a contact may differ from its stiffness in K, and to
/// what the forces of live contacts are solved.
constexpr double live_share = 0.5;
constexpr double solved_share = 0.02;

/// A direct search that has not found the equilibrium by then goes round in circles.
constexpr std::int64_t most_corrections = 50;

/// With more live contacts at once the crack has run ahead to where the gauge cannot follow it, and their dense problem
/// costs more than what comes next: a smaller increment, or momenta.
constexpr std::size_t most_live_contacts = 1250;

double reading(std::span<const SpringTerm> gauge, const std::vector<double>& motion) {
  double sum = 0.0;
  for (const SpringTerm& term : gauge) sum += term.factor * motion[term.freedom];
  return sum;
}

void add(double factor, const std::vector<double>& b, std::vector<double>& a) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

std::int64_t n_different(const std::vector<double>& a, const std::vector<double>& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

}  // namespace

void SecantRelaxation::declare(Parameters& parameters) {
  parameters
      .integer("most_changed_springs", most_changed_,
               "the stiffness is factorised anew when more springs of contacts than this have another one")
      .at_least(0);
  momenta_.declare(parameters);
}

bool SecantRelaxation::find(Increment& increment, const IncrementTarget& target) {
  if (find_directly(increment, target)) {
    remember_stiffness(increment.state().loading);
    return true;
  }
  // Momenta follow no gauge.
  if (!target.gauge.empty() || increment.is_interrupted()) return false;
  increment.restore();
  if (!momenta_.find(increment, target)) return false;
  ++increment.state().loading.n_relaxed;
  return true;
}

bool SecantRelaxation::find_live(Increment& increment, double step) {
  if (!momenta_.find_live(increment, step)) return false;
  ++increment.state().loading.n_relaxed;
  return true;
}

bool SecantRelaxation::find_directly(Increment& increment, const IncrementTarget& target) {
  increment.begin();
  prepare(increment);
  Course course = begin_course(increment, target);
  live_.clear();
  std::vector<double> motion(direction_.size(), 0.0);
  add(course.time, direction_, motion);
  for (;;) {
    if (!std::isfinite(product(motion, motion))) return false;
    course.gauge_left -= reading(course.gauge, motion);
    if (!course.gauge.empty()) increment.go_to(course.time * course.unit);
    increment.move(motion);
    if (increment.is_in_equilibrium()) return true;
    if (increment.is_exhausted() || increment.n_evaluations() > most_corrections) return false;
    std::optional<std::vector<double>> next = correction(increment, course);
    if (!next) return false;
    motion = *std::move(next);
  }
}

void SecantRelaxation::prepare(Increment& increment) {
  const State& state = increment.state();
  const LoadingState& loading = state.loading;
  std::vector<double> secants = increment.secants();
  const bool fits = loading.secants_update == state.search.n_updates && loading.secants.size() == secants.size() &&
                    n_different(loading.secants, secants) <= most_changed_;
  if (fits) {
    factorise(increment, loading.secants, loading.places);
  } else {
    factorise(increment, std::move(secants), all_displacements(increment.model(), state));
  }
}

void SecantRelaxation::factorise(Increment& increment, std::vector<double> secants, std::vector<double> places) {
  State& state = increment.state();
  if (!flexibility_.is_empty() && update_ == state.search.n_updates && secants == secants_ && places == places_) return;
  secants_ = std::move(secants);
  places_ = std::move(places);
  update_ = state.search.n_updates;
  // The stiffness is about the displacements of that time, so that a run that is taken up finds the same.
  const std::vector<double> now = all_displacements(increment.model(), state);
  set_displacements(places_, state);
  StiffnessSum sum = increment.stiffness();
  set_displacements(now, state);
  sum.set_stiffness(secants_);
  flexibility_.factorise(std::move(sum), increment.free());
}

void SecantRelaxation::remember_stiffness(LoadingState& loading) const {
  if (loading.secants_update == update_ && loading.secants == secants_ && loading.places == places_) return;
  loading.secants = secants_;
  loading.places = places_;
  loading.secants_update = update_;
  ++loading.n_factorisations;
}

SecantRelaxation::Course SecantRelaxation::begin_course(Increment& increment, const IncrementTarget& target) {
  const bool is_gauged = !target.gauge.empty();
  Course course{.gauge = target.gauge, .unit = is_gauged ? target.usual_time : target.step, .time = 1.0};
  increment.go_to(course.unit);
  direction_ = increment.prescribed_motion(course.unit);
  std::vector<double> forces = flexibility_.sum().times(direction_);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = increment.free()[i] * (increment.loads()[i] - increment.start_loads()[i] - forces[i]);
  }
  add(1.0, flexibility_.matrix().solve(forces), direction_);
  if (!is_gauged) return course;

  LoadingState& loading = increment.state().loading;
  course.gauge_rate = reading(target.gauge, direction_);
  if (loading.gauge_sign == 0.0) loading.gauge_sign = std::copysign(1.0, course.gauge_rate);
  course.gauge_left = loading.gauge_sign * target.step;
  course.time = course.gauge_left / course.gauge_rate;
  std::vector<double> factors(direction_.size(), 0.0);
  for (const SpringTerm& term : target.gauge) factors[term.freedom] += increment.free()[term.freedom] * term.factor;
  course.gauge_half = flexibility_.matrix().half(factors);
  return course;
}

void SecantRelaxation::find_live_contacts(const std::vector<LooseContact>& loose, double tolerance) {
  std::vector<std::size_t> all;
  auto known = live_.begin();
  for (const LooseContact& contact : loose) {
    const auto off = [&](std::size_t side) {
      return std::abs(contact.pull[side] - contact.pull_before[side] -
                      secants_[contact.spring + side] * contact.stretch[side]);
    };
    while (known != live_.end() && *known < contact.spring) ++known;
    const bool is_known = known != live_.end() && *known == contact.spring;
    if (is_known || std::max(off(0), off(1)) > tolerance) all.push_back(contact.spring);
  }
  live_ = std::move(all);
}

SpringProblem SecantRelaxation::live_problem(const Increment& increment, const std::vector<LooseContact>& loose,
                                             const std::vector<double>& half, double advance) {
  SpringProblem problem;
  springs_.clear();
  for (const std::size_t first : live_) springs_.insert(springs_.end(), {first, first + 1});
  problem.flexibility = flexibility_.between(springs_);
  auto contact = loose.begin();
  for (const std::size_t first : live_) {
    while (contact->spring < first) ++contact;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t spring = first + side;
      problem.reference.push_back(secants_[spring]);
      problem.stretch.push_back(contact->stretch[side]);
      problem.pull.push_back(contact->pull[side]);
      problem.aim.push_back(contact->stretch[side] + flexibility_.response(spring, half) +
                            advance * flexibility_.stretch(spring, direction_));
    }
  }
  problem.answer = [this, &increment](std::size_t pair, const SpringPair& stretch) {
    return increment.try_contact(live_[pair], stretch);
  };
  return problem;
}

std::vector<double> SecantRelaxation::hold_gauge(const Course& course, SpringProblem& problem) const {
  const std::size_t n = springs_.size();
  std::vector<double> time(n, 0.0);
  if (course.gauge.empty()) return time;
  for (std::size_t j = 0; j < n; ++j) {
    time[j] = flexibility_.response(springs_[j], course.gauge_half) / course.gauge_rate;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double along = flexibility_.stretch(springs_[i], direction_);
    for (std::size_t j = 0; j < n; ++j) problem.flexibility[i * n + j] -= along * time[j];
  }
  return time;
}

std::optional<std::vector<double>> SecantRelaxation::correction(Increment& increment, Course& course) {
  const double tolerance = increment.force_tolerance();
  const std::vector<LooseContact> loose = increment.loose_contacts();
  find_live_contacts(loose, live_share * tolerance);
  const SparseStiffness& matrix = flexibility_.matrix();
  std::vector<double> half = matrix.half(free_forces(increment.model(), increment.state()));
  double advance = 0.0;
  if (!course.gauge.empty()) advance = (course.gauge_left - product(course.gauge_half, half)) / course.gauge_rate;
  if (live_.size() > most_live_contacts) return {};
  if (!live_.empty()) {
    SpringProblem problem = live_problem(increment, loose, half, advance);
    const std::vector<double> time = hold_gauge(course, problem);
    const auto excess = solve_springs(problem, solved_share * tolerance);
    if (!excess) return {};
    for (std::size_t i = 0; i < excess->size(); ++i) {
      flexibility_.add_half(springs_[i], -(*excess)[i], half);
      advance += time[i] * (*excess)[i];
    }
  }
  std::vector<double> motion = matrix.back(std::move(half));
  if (course.gauge.empty()) return motion;
  add(advance, direction_, motion);
  course.time += advance;
  return motion;
}

}  // namespace ligament
