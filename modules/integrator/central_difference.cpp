#include "integrator/central_difference.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "core/parallel.hpp"
#include "integrator/ledger_lines.hpp"
#include "integrator/move_bodies.hpp"

namespace ligament {
namespace {

constexpr const char* step_change_line = "step_change";

/// Rows of a table.
struct Rows {
  std::size_t begin;
  std::size_t end;
};

// Both dampings act on the mean of v(n-½) and v(n+½), as their work does: they never give energy, and the step stays
// stable up to 2/ω. Local damping at most stops that mean.
void accelerate(TranslationState& bodies, const Field<Vector>& free, const DampingCoefficients& damping, double time,
                const Rows& rows) {
  const double factor = time / (1.0 + 0.5 * damping.viscous * time);
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    const Vector before = bodies.velocity[i];
    const Vector acceleration = bodies.force[i] / bodies.mass[i];
    const Vector undragged = before + factor * componentwise(free[i], acceleration - damping.viscous * before);
    const Vector drag = (factor * damping.local) * componentwise(free[i], absolute(acceleration));
    bodies.velocity_before[i] = before;
    bodies.velocity[i] = undragged - clamped(before + undragged, drag);
  }
}

void accelerate(RotationState& bodies, const Field<double>& free, const DampingCoefficients& damping, double time,
                const Rows& rows) {
  const double factor = time / (1.0 + 0.5 * damping.viscous * time);
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    const Spin before = bodies.spin[i];
    const double acceleration = bodies.moment[i] / bodies.inertia[i];
    const Spin undragged = before + factor * free[i] * (acceleration - damping.viscous * before);
    const double drag = factor * damping.local * free[i] * std::abs(acceleration);
    bodies.spin_before[i] = before;
    bodies.spin[i] = undragged - std::clamp(before + undragged, -drag, drag);
  }
}

/// The two halves of the work of a force in a step; see PathSum.
struct HalfWorks {
  double behind = 0.0;
  double ahead = 0.0;
  HalfWorks& operator+=(const HalfWorks& b) {
    behind += b.behind;
    ahead += b.ahead;
    return *this;
  }
};

/// Work on one body of what its motion shows beyond the force, where it is free: that of damping.
HalfWorks damping_work(const TranslationState& bodies, const Vector& free, const Clock& clock, std::size_t i) {
  const Vector change = bodies.velocity[i] - bodies.velocity_before[i];
  const Vector damping = componentwise(free, (bodies.mass[i] / clock.acceleration_time()) * change - bodies.force[i]);
  return {0.5 * dot(damping, bodies.increment[i]), 0.5 * clock.time_step * dot(damping, bodies.velocity[i])};
}

HalfWorks damping_work(const RotationState& bodies, double free, const Clock& clock, std::size_t i) {
  const Spin change = bodies.spin[i] - bodies.spin_before[i];
  const Moment damping = free * (bodies.inertia[i] / clock.acceleration_time() * change - bodies.moment[i]);
  return {0.5 * damping * bodies.increment[i], 0.5 * clock.time_step * damping * bodies.spin[i]};
}

/// The same for all bodies.
HalfWorks damping_work(const Model& model, const State& state) {
  HalfWorks all = block_sum(model.particles.size(), [&](std::size_t i) {
    HalfWorks work = damping_work(state.particles.translation, model.particles.free[i], state.clock, i);
    work += damping_work(state.particles.rotation, model.particles.rotation_free[i], state.clock, i);
    return work;
  });
  all += block_sum(model.nodes.size(), [&](std::size_t i) {
    return damping_work(state.nodes.translation, model.nodes.free[i], state.clock, i);
  });
  all += block_sum(model.beam_nodes.size(), [&](std::size_t i) {
    HalfWorks work = damping_work(state.beam_nodes.translation, model.beam_nodes.free[i], state.clock, i);
    work += damping_work(state.beam_nodes.rotation, model.beam_nodes.rotation_free[i], state.clock, i);
    return work;
  });
  return all;
}

/// When Δt changes at n, the resultant acts for (Δt_old + Δt_new)/2 but its work is booked over Δt_old behind and
/// Δt_new ahead; what is missing goes to a line of its own.
HalfWorks step_change_work(const TranslationState& bodies, const Clock& clock) {
  const double change = 0.5 * (clock.time_step - clock.time_step_before) / clock.acceleration_time();
  return block_sum(bodies.velocity.size(), [&](std::size_t i) {
    const Vector impulse = (0.5 * change * bodies.mass[i]) * (bodies.velocity[i] - bodies.velocity_before[i]);
    return HalfWorks{dot(impulse, bodies.velocity_before[i]), -dot(impulse, bodies.velocity[i])};
  });
}

HalfWorks step_change_work(const RotationState& bodies, const Clock& clock) {
  const double change = 0.5 * (clock.time_step - clock.time_step_before) / clock.acceleration_time();
  return block_sum(bodies.spin.size(), [&](std::size_t i) {
    const Moment impulse = 0.5 * change * bodies.inertia[i] * (bodies.spin[i] - bodies.spin_before[i]);
    return HalfWorks{impulse * bodies.spin_before[i], -impulse * bodies.spin[i]};
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

void CentralDifference::update_positions(const Model& /*model*/, State& state) const { move_bodies(state); }

void CentralDifference::update_velocities(const Model& model, State& state) {
  coefficients_ = damping_->coefficients(model, state);
  const double time = state.clock.acceleration_time();
  parallel_ranges(model.particles.size(), [&](std::size_t begin, std::size_t end) {
    accelerate(state.particles.translation, model.particles.free, coefficients_, time, {begin, end});
    accelerate(state.particles.rotation, model.particles.rotation_free, coefficients_, time, {begin, end});
  });
  parallel_ranges(model.nodes.size(), [&](std::size_t begin, std::size_t end) {
    accelerate(state.nodes.translation, model.nodes.free, coefficients_, time, {begin, end});
  });
  const Rows all_beams{0, model.beam_nodes.size()};
  accelerate(state.beam_nodes.translation, model.beam_nodes.free, coefficients_, time, all_beams);
  accelerate(state.beam_nodes.rotation, model.beam_nodes.rotation_free, coefficients_, time, all_beams);
}

void CentralDifference::book_work(const Model& model, State& state) {
  // Without damping what the motion shows beyond the forces is rounding.
  const bool is_damped = coefficients_.viscous != 0.0 || coefficients_.local != 0.0;
  const HalfWorks damping = is_damped ? damping_work(model, state) : HalfWorks{};
  state.ledger[state.ledger.open(ledger_lines::damping)].book(damping.behind, damping.ahead);

  HalfWorks step_change;
  if (state.clock.time_step != state.clock.time_step_before) {
    step_change += step_change_work(state.particles.translation, state.clock);
    step_change += step_change_work(state.particles.rotation, state.clock);
    step_change += step_change_work(state.nodes.translation, state.clock);
    step_change += step_change_work(state.beam_nodes.translation, state.clock);
    step_change += step_change_work(state.beam_nodes.rotation, state.clock);
  }
  state.ledger[state.ledger.open(step_change_line)].book(step_change.behind, step_change.ahead);
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
