#pragma once

#include <string>
#include <vector>

#include "core/model.hpp"

namespace ligament {

/// Whether sections stay normal to the axis, or shear.
enum class BeamTheory { euler_bernoulli, timoshenko };

/// A rectangular section.
struct BeamSection {
  double young_modulus = 0.0;  ///< E (Pa)
  double poisson_ratio = 0.0;  ///< ν
  double density = 0.0;        ///< ρ (kg/m3)
  double depth = 0.0;          ///< in the plane (m)
  double width = 0.0;          ///< across it (m)
  BeamTheory theory = BeamTheory::euler_bernoulli;

  [[nodiscard]] double area() const { return depth * width; }
  [[nodiscard]] double second_moment() const { return depth * depth * depth * width / 12.0; }
  /// G A_s = 5/6 G A (N).
  [[nodiscard]] double shear_rigidity() const {
    return 5.0 / 6.0 * area() * young_modulus / (2.0 * (1.0 + poisson_ratio));
  }
};

/// Adds a node that is free and weighs nothing yet.
Index add_beam_node(const Vector& position, double lever, Index id, BeamNodeData& nodes);

/// Adds a beam through these places, at least two, each apart from the next.
void add_beam(const std::string& name, const std::vector<Vector>& places, const BeamSection& section, Model& model);

}  // namespace ligament
