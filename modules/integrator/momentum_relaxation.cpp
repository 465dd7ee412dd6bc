#include "integrator/momentum_relaxation.hpp"

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"

namespace ligament {

void MomentumRelaxation::declare(Parameters& parameters) {
  bounds_.declare(parameters);
  parameters
      .quantity("coarse_cell", coarse_cell_, "m",
                "size of the cells of the coarse motions; default half of the shorter side of the structure")
      .greater_than(0.0);
}

void MomentumRelaxation::use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
  bounds_.check();
  mass_.emplace(model, state, stiffness, coarse_cell_);
}

bool MomentumRelaxation::find(Increment& increment, const IncrementTarget& target) {
  const double step = target.step;
  const LoadingState& loading = increment.state().loading;
  increment.begin();
  increment.go_to(step);
  std::vector<double> motion = increment.prescribed_motion(step);
  if (!loading.direction.empty() && loading.direction_step > 0.0) {
    const double scale = step / loading.direction_step;
    for (std::size_t i = 0; i < motion.size(); ++i) motion[i] += scale * loading.direction[i];
  }
  increment.move(motion);
  return relax(increment, {}, 0);
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
  const Model& model = increment.model();
  std::vector<double> momenta(increment.free().size(), 0.0);
  std::vector<double> free_before = free_forces(model, increment.state());
  std::vector<double> free_now = free_before;
  // At rest the first half of the step has no time to act.
  double damping = 2.0;
  for (std::int64_t n = 1;; ++n) {
    if (increment.is_exhausted()) return false;
    update_momenta(momenta, free_now, damping);
    std::vector<double> motion = mass_->velocities(momenta);
    if (n <= n_parts) {
      for (std::size_t i = 0; i < motion.size(); ++i) motion[i] += part[i];
    }
    increment.move(motion);
    increment.show(0.5 * product(motion, momenta));
    free_before = std::move(free_now);
    free_now = free_forces(model, increment.state());
    damping = adaptive_damping(motion, momenta, free_now, free_before, bounds_);
    if (increment.has_settled() && n >= n_parts) return true;
  }
}

}  // namespace ligament
