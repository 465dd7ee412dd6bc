#include "integrator/central_difference.hpp"

#include <utility>

#include "integrator/ledger_lines.hpp"
#include "integrator/move_bodies.hpp"

namespace ligament {
namespace {

constexpr const char* step_change_line = "step_change";

/// What was v(n+½) in the step before is v(n-½) now; older velocities are written over.
void begin_update(TranslationState& bodies) { std::swap(bodies.velocity, bodies.velocity_before); }
void begin_update(RotationState& bodies) { std::swap(bodies.spin, bodies.spin_before); }

/// Accelerates bodies that turn; returns the halves of the work of damping.
TwoSums accelerate(TurningState& bodies, const Field<Vector>& free, const Field<double>& rotation_free,
                   const MotionLaw& law) {
  begin_update(bodies.translation);
  begin_update(bodies.rotation);
  return sum_of_body_blocks(free.size(), [&](std::size_t begin, std::size_t end) {
    BlockTerms work;
    accelerate(bodies.translation, free, law, {begin, end}, work);
    accelerate(bodies.rotation, rotation_free, law, {begin, end}, work);
    return work.sum(end - begin);
  });
}

/// The same of nodes of elements.
TwoSums accelerate(NodeState& nodes, const Field<Vector>& free, const MotionLaw& law) {
  begin_update(nodes.translation);
  return sum_of_body_blocks(free.size(), [&](std::size_t begin, std::size_t end) {
    BlockTerms work;
    accelerate(nodes.translation, free, law, {begin, end}, work);
    return work.sum(end - begin);
  });
}

/// When Δt changes at n, the resultant acts for (Δt_old + Δt_new)/2 but its work is booked over Δt_old behind and
/// Δt_new ahead; what is missing goes to a line of its own.
TwoSums step_change_work(const TranslationState& bodies, const Clock& clock) {
  const double change = 0.5 * (clock.time_step - clock.time_step_before) / clock.acceleration_time();
  return block_sum(bodies.velocity.size(), [&](std::size_t i) {
    const Vector impulse = (0.5 * change * bodies.mass[i]) * (bodies.velocity[i] - bodies.velocity_before[i]);
    return TwoSums{dot(impulse, bodies.velocity_before[i]), -dot(impulse, bodies.velocity[i])};
  });
}

TwoSums step_change_work(const RotationState& bodies, const Clock& clock) {
  const double change = 0.5 * (clock.time_step - clock.time_step_before) / clock.acceleration_time();
  return block_sum(bodies.spin.size(), [&](std::size_t i) {
    const Moment impulse = 0.5 * change * bodies.inertia[i] * (bodies.spin[i] - bodies.spin_before[i]);
    return TwoSums{impulse * bodies.spin_before[i], -impulse * bodies.spin[i]};
  });
}

double kinetic_energy(const TranslationState& bodies) {
  return block_sum(bodies.velocity.size(), [&](std::size_t i) {
    return 0.5 * bodies.mass[i] * dot(bodies.velocity_before[i], bodies.velocity[i]);
  });
}

double kinetic_energy(const RotationState& bodies) {
  return block_sum(bodies.spin.size(),
                   [&](std::size_t i) { return 0.5 * bodies.inertia[i] * bodies.spin_before[i] * bodies.spin[i]; });
}

}  // namespace

StepTravel CentralDifference::update_positions(const Model& /*model*/, State& state) const {
  return move_bodies(state);
}

void CentralDifference::update_velocities(const Model& model, State& state) {
  const DampingCoefficients damping = damping_->coefficients(model, state);
  const MotionLaw law{damping, state.clock.acceleration_time(), state.clock.time_step_before, state.clock.time_step};
  TwoSums work = accelerate(state.particles, model.particles.free, model.particles.rotation_free, law);
  work += accelerate(state.nodes, model.nodes.free, law);
  work += accelerate(state.beam_nodes, model.beam_nodes.free, model.beam_nodes.rotation_free, law);
  // Without damping what the motion shows beyond the forces is rounding.
  const bool is_damped = damping.viscous != 0.0 || damping.local != 0.0;
  damping_work_ = is_damped ? work : TwoSums{};
}

void CentralDifference::book_work(const Model& /*model*/, State& state) {
  state.ledger[state.ledger.open(ledger_lines::damping)].book(damping_work_.first, damping_work_.second);

  TwoSums step_change;
  if (state.clock.time_step != state.clock.time_step_before) {
    step_change += step_change_work(state.particles.translation, state.clock);
    step_change += step_change_work(state.particles.rotation, state.clock);
    step_change += step_change_work(state.nodes.translation, state.clock);
    step_change += step_change_work(state.beam_nodes.translation, state.clock);
    step_change += step_change_work(state.beam_nodes.rotation, state.clock);
  }
  state.ledger[state.ledger.open(step_change_line)].book(step_change.first, step_change.second);
}

std::vector<EnergyTerm> CentralDifference::energies(const Model& model, const State& state) const {
  std::vector<EnergyTerm> terms{{"kinetic_particles", EnergyKind::kinetic, kinetic_energy(state.particles.translation)},
                                {"kinetic_rotation", EnergyKind::kinetic, kinetic_energy(state.particles.rotation)},
                                {"kinetic_nodes", EnergyKind::kinetic, kinetic_energy(state.nodes.translation)},
                                {"damping", EnergyKind::dissipated, 0.0 - state.ledger.total(ledger_lines::damping)},
                                {"step_change", EnergyKind::work, state.ledger.total(step_change_line)}};
  if (model.beam_nodes.size() > 0) {
    terms.push_back({"kinetic_beams", EnergyKind::kinetic,
                     kinetic_energy(state.beam_nodes.translation) + kinetic_energy(state.beam_nodes.rotation)});
  }
  return terms;
}

}  // namespace ligament
