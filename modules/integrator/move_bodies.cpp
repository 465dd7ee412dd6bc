#include "integrator/move_bodies.hpp"

#include <cmath>

#include "core/block_sum.hpp"
#include "core/largest.hpp"

namespace ligament {
namespace {

/// Largest squares of travels (m2) and turns (rad2).
struct LargestSquares {
  Largest travel;
  Largest turn;
  LargestSquares& operator+=(const LargestSquares& other) {
    travel += other.travel;
    turn += other.turn;
    return *this;
  }
};

[[gnu::target_clones("avx512f", "avx2", "default")]] Largest move_translations(std::size_t count, double time_step,
                                                                               const Vector* __restrict velocity,
                                                                               Vector* __restrict increment,
                                                                               Vector* __restrict displacement) {
  Largest square;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (int axis = 0; axis < dimension; ++axis) {
      const double step = time_step * component(velocity[i], axis);
      set_component(increment[i], axis, step);
      set_component(displacement[i], axis, component(displacement[i], axis) + step);
      sum += step * step;
    }
    square.see(sum);
  }
  return square;
}

[[gnu::target_clones("avx512f", "avx2", "default")]] Largest move_rotations(std::size_t count, double time_step,
                                                                            const Spin* __restrict spin,
                                                                            Rotation* __restrict increment,
                                                                            Rotation* __restrict rotation) {
  Largest square;
  for (std::size_t i = 0; i < count; ++i) {
    const Rotation step = time_step * spin[i];
    increment[i] = step;
    rotation[i] += step;
    square.see(step * step);
  }
  return square;
}

Largest move(TranslationState& bodies, double time_step, std::size_t begin, std::size_t end) {
  return move_translations(end - begin, time_step, bodies.velocity.data() + begin, bodies.increment.data() + begin,
                           bodies.displacement.data() + begin);
}

Largest move(RotationState& bodies, double time_step, std::size_t begin, std::size_t end) {
  return move_rotations(end - begin, time_step, bodies.spin.data() + begin, bodies.increment.data() + begin,
                        bodies.rotation.data() + begin);
}

LargestSquares move(TurningState& bodies, double time_step) {
  return sum_of_body_blocks(bodies.rotation.rotation.size(), [&](std::size_t begin, std::size_t end) {
    return LargestSquares{move(bodies.translation, time_step, begin, end),
                          move(bodies.rotation, time_step, begin, end)};
  });
}

Largest move(NodeState& nodes, double time_step) {
  return sum_of_body_blocks(nodes.translation.displacement.size(), [&](std::size_t begin, std::size_t end) {
    return move(nodes.translation, time_step, begin, end);
  });
}

}  // namespace

StepTravel move_bodies(State& state) {
  const double time_step = state.clock.time_step;
  const LargestSquares particles = move(state.particles, time_step);
  Largest nodes = move(state.nodes, time_step);
  nodes += move(state.beam_nodes, time_step).travel;
  return {.particles = std::sqrt(particles.travel.value()),
          .turn = std::sqrt(particles.turn.value()),
          .nodes = std::sqrt(nodes.value())};
}

}  // namespace ligament
