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

/// K u of one element of the state (N).
ElementDisplacement internal_force(const Model& model, const State& state, std::size_t element) {
  return stiffness_times(model.elements.stiffness[element],
                         displacement_of(model, state.nodes.translation.displacement, element));
}

/// The part of one corner.
Vector corner(const ElementDisplacement& f, std::size_t a) { return {f[2 * a], f[2 * a + 1]}; }

double row_sum(const ElementStiffness& stiffness, std::size_t row) {
  double sum = 0.0;
  for (std::size_t j = 0; j < 8; ++j) sum += std::abs(stiffness[8 * row + j]);
  return sum;
}

}  // namespace

void ElementForces::add_forces(const Model& model, State& state) {
  if (is_shared(model.elements.size())) {
    add_forces_by_node(model, state);
  } else {
    add_forces_by_element(model, state);
  }
}

void ElementForces::add_forces_by_element(const Model& model, State& state) {
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const ElementDisplacement f = internal_force(model, state, element);
    for (std::size_t a = 0; a < 4; ++a) {
      state.nodes.translation.force[model.elements.nodes[element][a]] -= corner(f, a);
    }
  }
}

void ElementForces::add_forces_by_node(const Model& model, State& state) {
  find_corners_at_nodes(model);
  internal_forces_.resize(model.elements.size());
  parallel_ranges(model.elements.size(), true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t element = begin; element < end; ++element) {
      internal_forces_[element] = internal_force(model, state, element);
    }
  });
  parallel_ranges(model.nodes.size(), true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      for (const std::size_t number : corners_at_nodes_.of(node)) {
        state.nodes.translation.force[node] -= corner(internal_forces_[number / 4], number % 4);
      }
    }
  });
}

/// Elements stay as they are while a model lives, but the same object may be given another model.
void ElementForces::find_corners_at_nodes(const Model& model) {
  if (nodes_ == model.elements.nodes && corners_at_nodes_.begin.size() == model.nodes.size() + 1) return;
  nodes_ = model.elements.nodes;
  Field<Index> corners;
  for (const auto& nodes : nodes_) corners.insert(corners.end(), nodes.begin(), nodes.end());
  corners_at_nodes_ = find_occurrences(corners, model.nodes.size());
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

void ElementForces::assemble(const Model& model, const State& /*state*/, StiffnessSum& stiffness) const {
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    std::array<Index, 8> freedoms;
    for (std::size_t k = 0; k < 8; ++k) {
      freedoms[k] = stiffness.numbers().node(model.elements.nodes[element][k / 2], static_cast<int>(k % 2));
    }
    stiffness.add_element(freedoms, model.elements.stiffness[element]);
  }
}

ForceMagnitudes ElementForces::internal_forces(const Model& model, const State& state) const {
  if (model.particles.size() > 0) return {};
  return block_sum(model.elements.size(), [&](std::size_t element) {
    const ElementDisplacement f = internal_force(model, state, element);
    ForceMagnitudes magnitudes;
    for (std::size_t a = 0; a < 4; ++a) {
      const double force = norm(corner(f, a));
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
