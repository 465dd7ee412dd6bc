#include "integrator/move_bodies.hpp"

#include "core/parallel.hpp"

namespace ligament {
namespace {

void move(TranslationState& bodies, double time_step) {
  parallel_ranges(bodies.displacement.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      bodies.increment[i] = time_step * bodies.velocity[i];
      bodies.displacement[i] += bodies.increment[i];
    }
  });
}

void move(RotationState& bodies, double time_step) {
  parallel_ranges(bodies.rotation.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      bodies.increment[i] = time_step * bodies.spin[i];
      bodies.rotation[i] += bodies.increment[i];
    }
  });
}

}  // namespace

void move_bodies(State& state) {
  move(state.particles.translation, state.clock.time_step);
  move(state.particles.rotation, state.clock.time_step);
  move(state.nodes.translation, state.clock.time_step);
}

}  // namespace ligament
