#pragma once

#include "core/model.hpp"
#include "mesh/boundary_facets.hpp"
#include "mesh/element_properties.hpp"
#include "mesh/structured_mesh.hpp"

namespace ligament::support {

/// Lines from `from` to `to` that cut it into `count` equal parts.
inline std::vector<double> even_lines(double from, double to, int count) {
  std::vector<double> lines;
  for (int i = 0; i <= count; ++i) lines.push_back(from + (to - from) * i / count);
  return lines;
}

/// Gives a model the elements of a grid (of its first material) and their boundary facets.
inline void add_mesh(Model& model, const GridLines& lines, const std::vector<Rectangle>& holes = {}) {
  StructuredMesh mesh = build_structured_mesh(lines, holes);
  model.nodes = std::move(mesh.nodes);
  model.elements = std::move(mesh.elements);
  model.elements.material.assign(model.elements.size(), 0);
  fill_element_properties(model);
  model.facets = find_boundary_facets(model.elements);
}

}  // namespace ligament::support
