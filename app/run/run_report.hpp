#pragma once

#include <string>

#include "build/build_simulation.hpp"

namespace ligament {

/// Sizes of a model, as the summary counts them.
struct ModelSizes {
  std::size_t n_particles = 0;
  std::size_t n_contacts = 0;       ///< bonds between particles at set-up
  std::size_t n_edge_contacts = 0;  ///< bonds with facets and nodes of elements at set-up
  std::size_t n_wall_contacts = 0;  ///< particles that touch walls at set-up
  std::size_t n_cut_contacts = 0;   ///< pairs, of all kinds, that notches keep from being bonded
  std::size_t n_elements = 0;
  std::size_t n_nodes = 0;
};
ModelSizes model_sizes(const Model& model);

/// Lines of the banner: sizes, packings, masses, time step and what limits it.
std::vector<std::string> describe(const Case& input, const BuiltSimulation& built);

/// Bytes of all arrays of model and state.
std::size_t memory_of(const Model& model, const State& state);

}  // namespace ligament
