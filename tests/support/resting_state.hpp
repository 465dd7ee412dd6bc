#pragma once

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament::support {

/// All bodies at rest in their places, no contacts yet.
inline State resting_state(const Model& model) {
  State state;
  const auto resize = [](TranslationState& bodies, std::size_t count) {
    for (Field<Vector>* field :
         {&bodies.displacement, &bodies.increment, &bodies.velocity_before, &bodies.velocity, &bodies.force}) {
      field->assign(count, Vector{});
    }
    bodies.mass.assign(count, 1.0);
  };
  resize(state.particles.translation, model.particles.size());
  resize(state.nodes.translation, model.nodes.size());
  RotationState& rotation = state.particles.rotation;
  for (Field<double>* field :
       {&rotation.rotation, &rotation.increment, &rotation.spin_before, &rotation.spin, &rotation.moment}) {
    field->assign(model.particles.size(), 0.0);
  }
  rotation.inertia.assign(model.particles.size(), 1.0);
  return state;
}

}  // namespace ligament::support
