#pragma once

#include "core/model.hpp"

namespace ligament {

/// Edges that belong to one element only, at the outside of the mesh and around its holes, each i→j with its element on
/// the left, in the order of the elements.
FacetData find_boundary_facets(const ElementData& elements);

}  // namespace ligament
