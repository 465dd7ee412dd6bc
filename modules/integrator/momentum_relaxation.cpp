#include "integrator/momentum_relaxation.hpp"

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/stiffness_mass.hpp"
#include "integrator/two_level_mass.hpp"

namespace ligament {
namespace {

/// Adds to a motion of prescribed freedoms in a step what free ones did in another, if that went on in time.
std::vector<double> extrapolated(std::vector<double> motion, double step, const Field<double>& direction,
                                 double direction_step) {
  if (!(direction_step > 0.0)) return motion;
  for (std::size_t i = 0; i < direction.size(); ++i) motion[i] += step / direction_step * direction[i];
  return motion;
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

}  // namespace

void MomentumRelaxation::declare(Parameters& parameters) {
  bounds_.declare(parameters);
  parameters.choice(
      "relaxation_mass", masses_, {{"stiffness", Masses::stiffness}, {"two_level", Masses::two_level}},
      "mass by which increments are relaxed: the factorised stiffness of the structure before any damage, or "
      "masses of two levels, which take less memory; live increments take the latter");
  parameters
      .quantity("coarse_cell", coarse_cell_, "m",
                "size of the cells of the coarse motions; default half of the shorter side of the structure")
      .greater_than(0.0);
}

void MomentumRelaxation::use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
  bounds_.check();
  two_level_mass_ = std::make_unique<TwoLevelMass>(model, state, stiffness, coarse_cell_);
  if (masses_ == Masses::stiffness) stiffness_mass_ = std::make_unique<StiffnessMass>(stiffness, free_mask(model));
}

RelaxationMass& MomentumRelaxation::mass(bool is_live) const {
  // choice: contacts that live are found and closed on the way, which the stiffness of set-up knows nothing of.
  return stiffness_mass_ && !is_live ? *stiffness_mass_ : *two_level_mass_;
}

bool MomentumRelaxation::find(Increment& increment, const IncrementTarget& target) {
  increment.begin();
  increment.go_to(target.step);
  move_as_before(increment, target.step);
  return relax(increment, {}, 0);
}

void MomentumRelaxation::move_as_before(Increment& increment, double step) {
  LoadingState& loading = increment.state().loading;
  const std::vector<double> platens = increment.prescribed_motion(step);
  const std::vector<double> last = extrapolated(platens, step, loading.direction, loading.direction_step);
  increment.move(last);
  if (loading.older_direction.empty()) return;

  const double unbalance_of_last = unbalance(increment);
  const std::vector<double> older = extrapolated(platens, step, loading.older_direction, loading.older_step);
  increment.move(difference(older, last));
  if (unbalance(increment) < unbalance_of_last) {
    std::swap(loading.direction, loading.older_direction);
    std::swap(loading.direction_step, loading.older_step);
  } else {
    increment.move(difference(last, older));
  }
}

double MomentumRelaxation::unbalance(const Increment& increment) {
  const std::vector<double> forces = increment.free_forces();
  return product(forces, mass(increment.is_live()).velocities(forces));
}

bool MomentumRelaxation::find_live(Increment& increment, double step) {
  // A platen that moves all at once would hit what it touches.
  constexpr std::int64_t n_parts = 100;
  increment.begin();
  increment.go_to(step);
  std::vector<double> part = increment.prescribed_motion(step);
  for (double& value : part) value /= n_parts;
  return relax(increment, part, n_parts);
}

bool MomentumRelaxation::relax(Increment& increment, const std::vector<double>& part, std::int64_t n_parts) {
  DampingBounds bounds = bounds_;
  // choice: contacts that live dissipate by themselves.
  if (increment.is_live()) bounds.smallest *= 0.5;
  std::vector<double> momenta(increment.free().size(), 0.0);
  std::vector<double> free_before = increment.free_forces();
  std::vector<double> free_now = free_before;
  // At rest the first half of the step has no time to act.
  double damping = 2.0;
  for (std::int64_t n = 1;; ++n) {
    if (increment.is_exhausted()) return false;
    update_momenta(momenta, free_now, damping);
    std::vector<double> motion = mass(increment.is_live()).velocities(momenta);
    if (n <= n_parts) {
      for (std::size_t i = 0; i < motion.size(); ++i) motion[i] += part[i];
    }
    increment.move(motion);
    increment.show(0.5 * product(motion, momenta));
    free_before = std::move(free_now);
    free_now = increment.free_forces();
    damping = adaptive_damping(motion, momenta, free_now, free_before, bounds);
    if (increment.has_settled() && n >= n_parts) return true;
  }
}

}  // namespace ligament
