#include "integrator/platens.hpp"

#include <optional>
#include <utility>

#include "integrator/prescribed_motion.hpp"

namespace ligament {
namespace {

/// Calls visit(platen, end node, r, number of the end) for every end.
template <class Visit>
void visit_ends(const Model& model, Visit&& visit) {
  std::size_t number = 0;
  for (const Platen& platen : model.platens) {
    for (const Index node : model.wall_nodes(platen.wall)) {
      visit(platen, node, model.nodes.position[node] - model.beam_nodes.position[platen.translation], number++);
    }
  }
}

}  // namespace

void place_platen_ends(const Model& model, State& state) {
  const TranslationState& middles = state.beam_nodes.translation;
  const RotationState& rotation = state.beam_nodes.rotation;
  TranslationState& ends = state.nodes.translation;
  visit_ends(model, [&](const Platen& platen, Index node, const Vector& arm, std::size_t /*number*/) {
    ends.displacement[node] = middles.displacement[platen.translation] + cross(rotation.rotation[platen.rotation], arm);
    ends.increment[node] = middles.increment[platen.translation] + cross(rotation.increment[platen.rotation], arm);
  });
}

void pass_on_platen_forces(const Model& model, State& state) {
  state.platens.force.resize(2 * model.platens.size());
  visit_ends(model, [&](const Platen& platen, Index node, const Vector& arm, std::size_t number) {
    const Vector force = std::exchange(state.nodes.translation.force[node], Vector{});
    state.platens.force[number] = force;
    state.beam_nodes.translation.force[platen.translation] += force;
    state.beam_nodes.rotation.moment[platen.rotation] += cross(arm, force);
  });
}

Vector holding_force(const Model& model, const State& state, Index node) {
  std::optional<Vector> from_middle;
  visit_ends(model, [&](const Platen& /*platen*/, Index end, const Vector& /*arm*/, std::size_t number) {
    if (end == node) from_middle = -state.platens.force[number];
  });
  return from_middle ? *from_middle : reaction(state.nodes.translation, model.nodes.free, state.clock, node);
}

void pass_on_platen_stiffness(const Model& model, StiffnessBounds& bounds) {
  visit_ends(model, [&](const Platen& platen, Index node, const Vector& arm, std::size_t /*number*/) {
    // |u + θ × r|² ≤ (1 + r/l) |u|² + (r/l)(1 + r/l) (l θ)².
    const double ratio = norm(arm) / model.beam_nodes.lever[platen.rotation];
    const double stiffness = std::exchange(bounds.node_translation[node], 0.0);
    bounds.beam_translation[platen.translation] += (1.0 + ratio) * stiffness;
    bounds.beam_rotation[platen.rotation] += ratio * (1.0 + ratio) * stiffness;
  });
}

}  // namespace ligament
