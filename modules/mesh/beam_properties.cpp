#include "mesh/beam_properties.hpp"

#include <algorithm>

namespace ligament {
namespace {

void add_element(Index first, const BeamSection& section, Model& model) {
  BeamNodeData& nodes = model.beam_nodes;
  const Index second = first + 1;
  const double length = norm(nodes.position[second] - nodes.position[first]);
  const double bending = section.young_modulus * section.second_moment();
  const bool shears = section.theory == BeamTheory::timoshenko;
  const double shear_ratio = shears ? 12.0 * bending / (section.shear_rigidity() * length * length) : 0.0;  // Φ
  model.beam_elements.nodes.push_back({first, second});
  model.beam_elements.axial.push_back(section.young_modulus * section.area() / length);
  model.beam_elements.bending.push_back(bending / length);
  model.beam_elements.shear.push_back(12.0 * bending / (length * length * length * (1.0 + shear_ratio)));
  const double mass_per_length = section.density * section.area();
  for (const Index node : {first, second}) {
    nodes.real_mass[node] += 0.5 * mass_per_length * length;
    // choice: half of the element turns with its node as a rigid bar does, and sections turn with it.
    nodes.real_inertia[node] +=
        0.5 * length * (mass_per_length * length * length / 12.0 + section.density * section.second_moment());
    nodes.lever[node] = std::max(nodes.lever[node], 0.5 * length);
  }
}

}  // namespace

Index add_beam_node(const Vector& position, double lever, Index id, BeamNodeData& nodes) {
  nodes.position.push_back(position);
  nodes.real_mass.push_back(0.0);
  nodes.real_inertia.push_back(0.0);
  nodes.lever.push_back(lever);
  nodes.id.push_back(id);
  nodes.free.push_back(uniform_vector(1.0));
  nodes.rotation_free.push_back(1.0);
  return static_cast<Index>(nodes.size() - 1);
}

void add_beam(const std::string& name, const std::vector<Vector>& places, const BeamSection& section, Model& model) {
  Beam beam{name, static_cast<Index>(model.beam_nodes.size()), static_cast<Index>(places.size())};
  for (std::size_t i = 0; i < places.size(); ++i) {
    add_beam_node(places[i], 0.0, static_cast<Index>(i + 1), model.beam_nodes);
  }
  for (Index i = 0; i + 1 < beam.n_nodes; ++i) add_element(beam.first_node + i, section, model);
  model.beams.push_back(std::move(beam));
}

}  // namespace ligament
