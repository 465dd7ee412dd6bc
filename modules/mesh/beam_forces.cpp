#include "mesh/beam_forces.hpp"

#include <algorithm>
#include <cmath>

#include "core/block_sum.hpp"
#include "mesh/beam_springs.hpp"

namespace ligament {

void BeamForces::add_forces(const Model& model, State& state) {
  for (std::size_t element = 0; element < model.beam_elements.size(); ++element) {
    const auto& [i, j] = model.beam_elements.nodes[element];
    const BeamAxis axis = beam_axis(model, element);
    const auto [elongation, bending, shear] = beam_modes(model, state, element);
    const double shear_force = shear.stiffness * shear.stretch;
    const Moment moment = bending.stiffness * bending.stretch;
    const Vector force = elongation.stiffness * elongation.stretch * axis.axial + shear_force * tangent(axis.axial);
    state.beam_nodes.translation.force[i] += force;
    state.beam_nodes.translation.force[j] -= force;
    state.beam_nodes.rotation.moment[i] += moment + 0.5 * axis.length * shear_force;
    state.beam_nodes.rotation.moment[j] += 0.5 * axis.length * shear_force - moment;
  }
}

void BeamForces::add_stiffness(const Model& model, const State& /*state*/, StiffnessBounds& bounds) const {
  for (std::size_t element = 0; element < model.beam_elements.size(); ++element) {
    const auto& [i, j] = model.beam_elements.nodes[element];
    const double lever_i = model.beam_nodes.lever[i];
    const double lever_j = model.beam_nodes.lever[j];
    const double half = 0.5 * beam_axis(model, element).length;
    // Of a spring k b bᵀ the row of a freedom is k |b_i| Σ |b_j|; elongation and shear stand normal to each other.
    const double row_of_shear = model.beam_elements.shear[element] * (2.0 + half / lever_i + half / lever_j);
    const double translation = std::max(2.0 * model.beam_elements.axial[element], row_of_shear);
    const double row_of_moment = model.beam_elements.bending[element] * (1.0 / lever_i + 1.0 / lever_j);
    for (const Index node : {i, j}) {
      const double lever = model.beam_nodes.lever[node];
      bounds.beam_translation[node] += translation;
      bounds.beam_rotation[node] += (half * row_of_shear + row_of_moment) / lever;
    }
  }
}

void BeamForces::assemble(const Model& model, const State& /*state*/, StiffnessSum& stiffness) const {
  const FreedomNumbers& numbers = stiffness.numbers();
  for (std::size_t element = 0; element < model.beam_elements.size(); ++element) {
    const auto& [i, j] = model.beam_elements.nodes[element];
    const BeamAxis axis = beam_axis(model, element);
    const auto apart_along = [&numbers, first = i, second = j](const Vector& direction) {
      std::vector<SpringTerm> terms;
      for (int k = 0; k < dimension; ++k) {
        terms.push_back({numbers.beam_node(first, k), -component(direction, k)});
        terms.push_back({numbers.beam_node(second, k), component(direction, k)});
      }
      return terms;
    };
    stiffness.add_spring(apart_along(axis.axial), model.beam_elements.axial[element]);
    const std::vector<SpringTerm> turn{{numbers.beam_rotation(i), -1.0}, {numbers.beam_rotation(j), 1.0}};
    stiffness.add_spring(turn, model.beam_elements.bending[element]);
    std::vector<SpringTerm> shear = apart_along(tangent(axis.axial));
    for (const Index node : {i, j}) shear.push_back({numbers.beam_rotation(node), -0.5 * axis.length});
    stiffness.add_spring(shear, model.beam_elements.shear[element]);
  }
}

void BeamForces::add_secants(const Model& model, const State& /*state*/, const ContactMemory& /*before*/,
                             std::vector<double>& stiffness) const {
  const BeamElementData& elements = model.beam_elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    stiffness.insert(stiffness.end(), {elements.axial[i], elements.bending[i], elements.shear[i]});
  }
}

ForceMagnitudes BeamForces::internal_forces(const Model& model, const State& state) const {
  // Where there is nothing else to compare with.
  if (model.particles.size() > 0 || model.elements.size() > 0) return {};
  return block_sum(model.beam_elements.size(), [&](std::size_t element) {
    const auto modes = beam_modes(model, state, element);
    const double force = std::abs(modes[0].stiffness * modes[0].stretch) +
                         std::abs(modes[2].stiffness * modes[2].stretch) +
                         std::abs(modes[1].stiffness * modes[1].stretch) / beam_axis(model, element).length;
    return ForceMagnitudes{force, force > 0.0 ? 1.0 : 0.0};
  });
}

std::vector<EnergyTerm> BeamForces::energies(const Model& model, const State& state) const {
  const double energy = block_sum(model.beam_elements.size(), [&](std::size_t element) {
    double sum = 0.0;
    for (const BeamMode& mode : beam_modes(model, state, element)) {
      sum += 0.5 * mode.stiffness * mode.stretch * mode.stretch;
    }
    return sum;
  });
  return {{"elastic_beams", EnergyKind::elastic, energy}};
}

}  // namespace ligament
