#include "integrator/move_bodies.hpp"

#include "core/parallel.hpp"

namespace ligament {
namespace {

/// Rows of a table.
struct Rows {
  std::size_t begin;
  std::size_t end;
};

void move(TranslationState& bodies, double time_step, const Rows& rows) {
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    bodies.increment[i] = time_step * bodies.velocity[i];
    bodies.displacement[i] += bodies.increment[i];
  }
}

void move(RotationState& bodies, double time_step, const Rows& rows) {
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    bodies.increment[i] = time_step * bodies.spin[i];
    bodies.rotation[i] += bodies.increment[i];
  }
}

}  // namespace

void move_bodies(State& state) {
  const double time_step = state.clock.time_step;
  parallel_bodies(state.particles.rotation.rotation.size(), [&](std::size_t begin, std::size_t end) {
    move(state.particles.translation, time_step, {begin, end});
    move(state.particles.rotation, time_step, {begin, end});
  });
  parallel_bodies(state.nodes.translation.displacement.size(), [&](std::size_t begin, std::size_t end) {
    move(state.nodes.translation, time_step, {begin, end});
  });
  const Rows all_beams{0, state.beam_nodes.rotation.rotation.size()};
  move(state.beam_nodes.translation, time_step, all_beams);
  move(state.beam_nodes.rotation, time_step, all_beams);
}

}  // namespace ligament
