#pragma once

#include "integrator/loads.hpp"
#include "support/element_model.hpp"

namespace ligament::support {

/// A bar along x of one row of elements with E = ρ = 1 and ν = 0, so that waves run with c = 1, of height and thickness
/// 1; nodes 0 … n are its lower side, n + 1 … 2 n + 1 the upper one. Nodes move along x only.
inline Model bar_model(int n_elements, double length) {
  Model model = element_model(build_structured_mesh({even_lines(0.0, length, n_elements), {0.0, 1.0}}, {}), {});
  for (Vector& free : model.nodes.free) free = {1.0, 0.0};
  return model;
}

/// The two nodes of a cross-section, counted from the left end.
inline std::array<Index, 2> section(const Model& model, Index number) {
  return {number, number + static_cast<Index>(model.nodes.size() / 2)};
}
inline std::array<Index, 2> last_section(const Model& model) {
  return section(model, static_cast<Index>(model.nodes.size() / 2 - 1));
}

inline void hold(Model& model, const std::array<Index, 2>& nodes) {
  for (const Index node : nodes) model.nodes.free[node] = {};
}

/// An axial force shared by the nodes of a section.
inline std::vector<PointLoad> pull(const std::array<Index, 2>& nodes, double force, double rise_time = 0.0) {
  std::vector<PointLoad> loads;
  for (const Index node : nodes) {
    loads.push_back({.row = node, .force = {0.5 * force, 0.0}, .rise_time = rise_time});
  }
  return loads;
}

}  // namespace ligament::support
