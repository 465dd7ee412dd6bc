#include "audit/step_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/lost_body.hpp"
#include "core/block_sum.hpp"
#include "core/error.hpp"

namespace ligament {
namespace {

double work(const Field<Vector>& before, const TranslationState& bodies) {
  return block_sum(before.size(),
                   [&](std::size_t i) { return 0.5 * dot(before[i] + bodies.force[i], bodies.increment[i]); });
}

double work(const Field<Moment>& before, const RotationState& bodies) {
  return block_sum(before.size(),
                   [&](std::size_t i) { return 0.5 * (before[i] + bodies.moment[i]) * bodies.increment[i]; });
}

}  // namespace

StepAudit::StepAudit(const Simulation& simulation) : before_(sides_of(simulation)) { remember(simulation.state()); }

void StepAudit::observe(const Simulation& simulation) {
  const State& state = simulation.state();
  if (const std::string body = describe_infinite_body(simulation.model(), state); !body.empty()) {
    throw DivergenceError(fmt::format("step {}: {}", state.clock.step, body));
  }
  const Sides now = sides_of(simulation);
  const double on_bodies = work_on_bodies(state);
  const double size = std::max({std::abs(now.of_loads), std::abs(now.taken), std::abs(now.kinetic)});
  motion_.add(now.kinetic - before_.kinetic - on_bodies - (now.of_motion - before_.of_motion), size);
  transfer_.add(on_bodies - (now.of_loads - before_.of_loads) + (now.taken - before_.taken), size);
  before_ = now;
  remember(state);
}

void StepAudit::Drift::add(double defect, double size) {
  sum += defect;
  largest = std::max(largest, std::abs(sum));
  scale = std::max(scale, size);
}

StepAudit::Sides StepAudit::sides_of(const Simulation& simulation) {
  Sides sides;
  for (const EnergyTerm& term : simulation.energies()) {
    const bool is_of_motion = term.name == "damping" || term.name == "prescribed_motions" || term.name == "step_change";
    if (term.kind == EnergyKind::kinetic) {
      sides.kinetic += term.value;
    } else if (is_of_motion) {
      sides.of_motion += term.kind == EnergyKind::dissipated ? -term.value : term.value;
    } else if (term.kind == EnergyKind::work) {
      sides.of_loads += term.value;
    } else {
      sides.taken += term.value;
    }
  }
  return sides;
}

double StepAudit::work_on_bodies(const State& state) const {
  return work(particle_force_, state.particles.translation) + work(node_force_, state.nodes.translation) +
         work(beam_force_, state.beam_nodes.translation) + work(particle_moment_, state.particles.rotation) +
         work(beam_moment_, state.beam_nodes.rotation);
}

void StepAudit::remember(const State& state) {
  particle_force_ = state.particles.translation.force;
  particle_moment_ = state.particles.rotation.moment;
  node_force_ = state.nodes.translation.force;
  beam_force_ = state.beam_nodes.translation.force;
  beam_moment_ = state.beam_nodes.rotation.moment;
}

}  // namespace ligament
