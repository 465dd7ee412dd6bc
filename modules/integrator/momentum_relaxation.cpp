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

  std::vector<double> momenta(motion.size(), 0.0);
  std::vector<double> free_before = free_forces(increment.model(), increment.state());
  std::vector<double> free_now = free_before;
  // At rest the first half of the step has no time to act.
  double damping = 2.0;
  do {
    if (increment.is_exhausted()) return false;
    update_momenta(momenta, free_now, damping);
    motion = mass_->velocities(momenta);
    increment.move(motion);
    free_before = std::move(free_now);
    free_now = free_forces(increment.model(), increment.state());
    damping = adaptive_damping(motion, momenta, free_now, free_before, bounds_);
  } while (!increment.has_settled());
  return true;
}

}  // namespace ligament
