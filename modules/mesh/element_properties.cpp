#include "mesh/element_properties.hpp"

namespace ligament {
namespace {

std::array<PlaneTensor, 3> elasticity_of(const Model& model, std::size_t element) {
  const Material& material = model.materials[model.elements.material[element]];
  return elasticity_matrix(material.young_modulus, material.poisson_ratio, model.plane);
}

}  // namespace

QuadrilateralCorners corners_of(const Model& model, std::size_t element) {
  QuadrilateralCorners corners;
  for (std::size_t a = 0; a < 4; ++a) corners[a] = model.nodes.position[model.elements.nodes[element][a]];
  return corners;
}

ElementDisplacement displacement_of(const Model& model, const Field<Vector>& node_displacement, std::size_t element) {
  ElementDisplacement displacement{};
  for (std::size_t a = 0; a < 4; ++a) {
    const Vector& u = node_displacement[model.elements.nodes[element][a]];
    displacement[2 * a] = u.x;
    displacement[2 * a + 1] = u.y;
  }
  return displacement;
}

void fill_element_properties(Model& model) {
  model.elements.stiffness.resize(model.elements.size());
  model.nodes.real_mass.assign(model.nodes.size(), 0.0);
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const QuadrilateralCorners corners = corners_of(model, element);
    model.elements.stiffness[element] =
        quadrilateral_stiffness(corners, elasticity_of(model, element), model.thickness);
    const double mass_per_area = model.materials[model.elements.material[element]].density * model.thickness;
    const auto areas = quadrilateral_lumped_areas(corners);
    for (std::size_t a = 0; a < 4; ++a) {
      model.nodes.real_mass[model.elements.nodes[element][a]] += mass_per_area * areas[a];
    }
  }
}

ElementStress element_stress(const Model& model, const Field<Vector>& node_displacement, std::size_t element) {
  const PlaneTensor strain =
      quadrilateral_mean_strain(corners_of(model, element), displacement_of(model, node_displacement, element));
  return {strain, stress_of(elasticity_of(model, element), strain)};
}

}  // namespace ligament
