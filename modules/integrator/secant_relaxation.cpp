#include "integrator/secant_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"

namespace ligament {
namespace {

double reading(std::span<const SpringTerm> gauge, const std::vector<double>& motion) {
  double sum = 0.0;
  for (const SpringTerm& term : gauge) sum += term.factor * motion[term.freedom];
  return sum;
}

void add(double factor, const std::vector<double>& b, std::vector<double>& a) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Changes of a secant, over the largest one: those that are not worth other factors, and those that are at once, as
/// where a contact opens or closes.
constexpr double small_change = 1e-3;
constexpr double large_change = 0.3;

}  // namespace

void SecantRelaxation::declare(Parameters& parameters) {
  parameters
      .integer("keep_factors", keep_factors_,
               "iterations with one factorised stiffness, unless contacts open or close in the meantime")
      .at_least(1);
}

void SecantRelaxation::factorise(Increment& increment, std::vector<double> secants, double time) {
  sum_->set_stiffness(secants);
  secants_ = std::move(secants);
  n_uses_ = 0;
  matrix_.factorise(*sum_, increment.free());
  ++increment.state().loading.n_factorisations;

  increment.go_to(time);
  direction_ = increment.prescribed_motion(time);
  std::vector<double> forces = sum_->times(direction_);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = increment.free()[i] * (increment.loads()[i] - increment.start_loads()[i] - forces[i]);
  }
  add(1.0, matrix_.solve(forces), direction_);
}

bool SecantRelaxation::is_outdated(const std::vector<double>& secants) const {
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < secants.size(); ++i) {
    largest = std::max(largest, secants[i]);
    change = std::max(change, std::abs(secants[i] - secants_[i]));
  }
  return change > (n_uses_ < keep_factors_ ? large_change : small_change) * largest;
}

std::vector<double> SecantRelaxation::correction(Increment& increment) {
  ++n_uses_;
  return matrix_.solve(free_forces(increment.model(), increment.state()));
}

bool SecantRelaxation::find(Increment& increment, const IncrementTarget& target) {
  LoadingState& loading = increment.state().loading;
  const bool is_gauged = !target.gauge.empty();
  const double unit = is_gauged ? target.usual_time : target.step;
  increment.begin();
  sum_.emplace(increment.stiffness());
  // What contacts carried their forces with at the last equilibrium, unless the list of contacts is another one.
  factorise(increment, loading.secants.size() == sum_->n_springs() ? loading.secants : increment.secants(), unit);
  if (is_gauged && loading.gauge_sign == 0.0) {
    loading.gauge_sign = std::copysign(1.0, reading(target.gauge, direction_));
  }

  double gauge_left = loading.gauge_sign * target.step;
  double time = 0.0;  // in units
  std::vector<double> motion(direction_.size(), 0.0);
  for (;;) {
    double advance = time > 0.0 ? 0.0 : 1.0;
    if (is_gauged) advance = (gauge_left - reading(target.gauge, motion)) / reading(target.gauge, direction_);
    add(advance, direction_, motion);
    time += advance;
    if (!std::isfinite(product(motion, motion))) return false;
    if (is_gauged) {
      gauge_left -= reading(target.gauge, motion);
      increment.go_to(time * unit);
    }
    increment.move(motion);
    if (increment.has_settled()) break;
    if (increment.is_exhausted()) return false;
    std::vector<double> secants = increment.secants();
    if (is_outdated(secants)) {
      factorise(increment, std::move(secants), unit);
      increment.go_to(time * unit);
    }
    motion = correction(increment);
  }
  loading.secants = increment.secants();
  return true;
}

}  // namespace ligament
