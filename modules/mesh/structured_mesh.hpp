#pragma once

#include <vector>

#include "core/model.hpp"
#include "core/rectangle.hpp"

namespace ligament {

/// Lines of a rectangular grid (m), ascending.
struct GridLines {
  std::vector<double> x;
  std::vector<double> y;
};

/// Nodes and elements of the grid, numbered row by row from the bottom left, without the elements inside the holes and
/// the nodes that only they have. Ids are those of the full grid. Stiffness and masses are not filled.
/// Throws InputError if the border of a hole does not follow lines of the grid.
struct StructuredMesh {
  NodeData nodes;
  ElementData elements;
};
StructuredMesh build_structured_mesh(const GridLines& lines, const std::vector<Rectangle>& holes);

/// True where a rectangle is a block of whole elements of the grid.
bool is_block_of_grid(const GridLines& lines, const Rectangle& rectangle);

}  // namespace ligament
