#include "run/external_forces.hpp"

#include "core/block_sum.hpp"

namespace ligament {
namespace {

Vector sum(const Field<Vector>& forces) {
  return block_sum(forces.size(), [&](std::size_t i) { return forces[i]; });
}

}  // namespace

std::optional<double> ExternalForces::mismatch() const {
  const double size = norm(driving);
  if (!(size > 0.0)) return std::nullopt;
  return lacking() / size;
}

ExternalForces external_forces(const Simulation& simulation, const std::vector<PrescribedFreedom>& freedoms) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  ExternalForces forces;
  // Internal forces cancel: what remains of the resultants is loads and gravity.
  forces.driving = sum(state.particles.translation.force) + sum(state.nodes.translation.force) +
                   sum(state.beam_nodes.translation.force);
  for (const PrescribedFreedom& freedom : freedoms) {
    if (freedom.axis >= dimension) continue;
    const Vector holding =
        reaction(translation_of(state, freedom.body), free_of(model, freedom.body), state.clock, freedom.row);
    const double force = component(holding, freedom.axis);
    Vector& side = freedom.motions.empty() ? forces.supporting : forces.driving;
    set_component(side, freedom.axis, component(side, freedom.axis) + force);
  }
  return forces;
}

}  // namespace ligament
