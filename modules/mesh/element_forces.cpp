#include "mesh/element_forces.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "mesh/element_properties.hpp"

namespace ligament {
namespace {

/// K u of one element (N).
ElementDisplacement stiffness_times(const ElementStiffness& stiffness, const ElementDisplacement& u) {
  ElementDisplacement force{};
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) force[i] += stiffness[8 * i + j] * u[j];
  }
  return force;
}

double row_sum(const ElementStiffness& stiffness, std::size_t row) {
  double sum = 0.0;
  for (std::size_t j = 0; j < 8; ++j) sum += std::abs(stiffness[8 * row + j]);
  return sum;
}

}  // namespace

void ElementForces::add_forces(const Model& model, State& state) {
  const Field<Vector>& displacement = state.nodes.translation.displacement;
  Field<Vector>& force = state.nodes.translation.force;
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const ElementDisplacement f =
        stiffness_times(model.elements.stiffness[element], displacement_of(model, displacement, element));
    for (std::size_t a = 0; a < 4; ++a) {
      force[model.elements.nodes[element][a]] -= Vector{f[2 * a], f[2 * a + 1]};
    }
  }
}

void ElementForces::add_stiffness(const Model& model, const State& /*state*/, StiffnessBounds& bounds) const {
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const ElementStiffness& stiffness = model.elements.stiffness[element];
    for (std::size_t a = 0; a < 4; ++a) {
      bounds.node_translation[model.elements.nodes[element][a]] +=
          std::max(row_sum(stiffness, 2 * a), row_sum(stiffness, 2 * a + 1));
    }
  }
}

ForceMagnitudes ElementForces::internal_forces(const Model& model, const State& state) const {
  if (model.particles.size() > 0) return {};
  return block_sum(model.elements.size(), [&](std::size_t element) {
    const ElementDisplacement f = stiffness_times(
        model.elements.stiffness[element], displacement_of(model, state.nodes.translation.displacement, element));
    ForceMagnitudes magnitudes;
    for (std::size_t a = 0; a < 4; ++a) {
      const double force = norm({f[2 * a], f[2 * a + 1]});
      magnitudes += {force, force > 0.0 ? 1.0 : 0.0};
    }
    return magnitudes;
  });
}

std::vector<EnergyTerm> ElementForces::energies(const Model& model, const State& state) const {
  const double energy = block_sum(model.elements.size(), [&](std::size_t element) {
    const ElementDisplacement u = displacement_of(model, state.nodes.translation.displacement, element);
    const ElementDisplacement f = stiffness_times(model.elements.stiffness[element], u);
    double sum = 0.0;
    for (std::size_t i = 0; i < 8; ++i) sum += 0.5 * u[i] * f[i];
    return sum;
  });
  return {{"elastic_elements", EnergyKind::elastic, energy}};
}

}  // namespace ligament
