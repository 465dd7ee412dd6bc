#pragma once

#include "core/state.hpp"

namespace ligament {

/// All bodies as they were: motions, forces, and what platens pass on.
class BodyMemory {
 public:
  void take(const State& state) {
    particles_ = state.particles;
    nodes_ = state.nodes;
    beam_nodes_ = state.beam_nodes;
    platens_ = state.platens;
  }
  void put_back(State& state) const {
    state.particles = particles_;
    state.nodes = nodes_;
    state.beam_nodes = beam_nodes_;
    state.platens = platens_;
  }

 private:
  ParticleState particles_;
  NodeState nodes_;
  BeamNodeState beam_nodes_;
  PlatenState platens_;
};

}  // namespace ligament
