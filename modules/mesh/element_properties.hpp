#pragma once

#include "core/model.hpp"
#include "mesh/quadrilateral.hpp"

namespace ligament {

/// Corners of an element at rest (m).
QuadrilateralCorners corners_of(const Model& model, std::size_t element);

/// Displacement of an element's nodes (m).
ElementDisplacement displacement_of(const Model& model, const Field<Vector>& node_displacement, std::size_t element);

/// Stiffness of all elements and lumped masses of all nodes from the materials, plane state and thickness of the model.
void fill_element_properties(Model& model);

/// Mean strain and stress of an element (Pa), for output.
struct ElementStress {
  PlaneTensor strain;
  PlaneTensor stress;
};
ElementStress element_stress(const Model& model, const Field<Vector>& node_displacement, std::size_t element);

}  // namespace ligament
