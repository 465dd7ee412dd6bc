#pragma once

#include <utility>

#include "mesh/boundary_facets.hpp"
#include "mesh/element_properties.hpp"
#include "mesh/structured_mesh.hpp"
#include "support/meshed_model.hpp"

namespace ligament::support {

/// What the tests ask of a continuum.
struct Continuum {
  double young_modulus = 1.0;
  double poisson_ratio = 0.0;
  double density = 1.0;
  double thickness = 1.0;
  PlaneState plane = PlaneState::stress;
};

/// A model of elements alone; nodes are free unless the mesh says otherwise.
inline Model element_model(StructuredMesh mesh, const Continuum& continuum) {
  Model model;
  model.thickness = continuum.thickness;
  model.plane = continuum.plane;
  model.materials.push_back({.name = "continuum",
                             .young_modulus = continuum.young_modulus,
                             .poisson_ratio = continuum.poisson_ratio,
                             .density = continuum.density});
  model.nodes = std::move(mesh.nodes);
  model.elements = std::move(mesh.elements);
  model.elements.material.assign(model.elements.size(), 0);
  model.facets = find_boundary_facets(model.elements);
  fill_element_properties(model);
  return model;
}

/// Moves the nodes of a mesh: place(position) is their new position.
template <class Place>
StructuredMesh mapped(StructuredMesh mesh, Place&& place) {
  for (Vector& position : mesh.nodes.position) position = place(position);
  return mesh;
}

}  // namespace ligament::support
