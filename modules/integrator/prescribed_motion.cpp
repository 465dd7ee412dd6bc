#include "integrator/prescribed_motion.hpp"

#include <algorithm>

#include "integrator/ledger_lines.hpp"

namespace ligament {
namespace {

double velocity_at(const StageVelocity& motion, double time) {
  if (motion.stop_time >= 0.0 && time >= motion.stop_time) return 0.0;
  const double share = motion.rise_time > 0.0 ? std::min(1.0, time / motion.rise_time) : 1.0;
  return share * motion.velocity;
}

/// What a freedom's equation of motion is made of.
struct FreedomState {
  double inertia;
  double velocity_before;
  double velocity;
  double increment;
  double force;

  /// m (v₊ - v₋)/Δt less the resultant: the force that prescribes the motion.
  [[nodiscard]] double reaction(const Clock& clock) const {
    return inertia * (velocity - velocity_before) / clock.acceleration_time() - force;
  }
};

FreedomState state_of(const PrescribedFreedom& freedom, const State& state) {
  const Index row = freedom.row;
  if (freedom.axis == dimension) {
    const RotationState& bodies = rotation_of(state, freedom.body);
    return {bodies.inertia[row], bodies.spin_before[row], bodies.spin[row], bodies.increment[row], bodies.moment[row]};
  }
  const TranslationState& bodies = translation_of(state, freedom.body);
  return {bodies.mass[row], component(bodies.velocity_before[row], freedom.axis),
          component(bodies.velocity[row], freedom.axis), component(bodies.increment[row], freedom.axis),
          component(bodies.force[row], freedom.axis)};
}

}  // namespace

double prescribed_velocity(const PrescribedFreedom& freedom, const StageState& stage, double begin, double duration) {
  for (const StageVelocity& motion : freedom.motions) {
    if (motion.stage != stage.number) continue;
    if (motion.schedule.empty()) return velocity_at(motion, begin + 0.5 * duration - stage.begin_time);
    return motion.schedule.mean_slope(begin - stage.begin_time, begin + duration - stage.begin_time);
  }
  return 0.0;
}

void PrescribedMotion::fix(Model& model) const {
  for (const PrescribedFreedom& freedom : freedoms_) {
    if (freedom.axis == dimension) {
      rotation_free_of(model, freedom.body)[freedom.row] = 0.0;
    } else {
      set_component(free_of(model, freedom.body)[freedom.row], freedom.axis, 0.0);
    }
  }
}

void PrescribedMotion::apply(const Model& /*model*/, State& state) {
  const double time = state.clock.time;
  for (const PrescribedFreedom& freedom : freedoms_) {
    const double velocity = prescribed_velocity(freedom, state.stage, time, state.clock.time_step);
    if (freedom.axis == dimension) {
      rotation_of(state, freedom.body).spin[freedom.row] = velocity;
    } else {
      set_component(translation_of(state, freedom.body).velocity[freedom.row], freedom.axis, velocity);
    }
  }
}

void PrescribedMotion::book_work(const Model& /*model*/, State& state) {
  double behind = 0.0;
  double ahead = 0.0;
  for (const PrescribedFreedom& freedom : freedoms_) {
    const FreedomState body = state_of(freedom, state);
    const double reaction = body.reaction(state.clock);
    behind += 0.5 * reaction * body.increment;
    ahead += 0.5 * reaction * body.velocity * state.clock.time_step;
  }
  state.ledger[state.ledger.open(ledger_lines::prescribed_motions)].book(behind, ahead);
}

std::vector<EnergyTerm> PrescribedMotion::energies(const Model& /*model*/, const State& state) const {
  return {{ledger_lines::prescribed_motions, EnergyKind::work, state.ledger.total(ledger_lines::prescribed_motions)}};
}

Vector reaction(const TranslationState& bodies, const Field<Vector>& free, const Clock& clock, Index row) {
  const Vector shown =
      (bodies.mass[row] / clock.acceleration_time()) * (bodies.velocity[row] - bodies.velocity_before[row]);
  return componentwise(uniform_vector(1.0) - free[row], shown - bodies.force[row]);
}

}  // namespace ligament
