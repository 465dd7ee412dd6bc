#pragma once

#include <cmath>

#include "core/parameters.hpp"
#include "core/rectangle.hpp"
#include "generation/hexagonal.hpp"
#include "generation/register_generators.hpp"
#include "support/hand_made_model.hpp"
#include "support/meshed_model.hpp"

namespace ligament::support {

/// A strip of elements with a zone of hexagonal particles in its middle: elements | particles | elements.
struct HybridStrip {
  double young_modulus = 20e9;
  double poisson_ratio = 0.2;
  double density = 2400.0;
  double radius = 0.02;
  double height = 0.4;
  double zone_length = 0.8;
  double side_length = 0.8;    ///< of the elements on either side (m)
  double element_size = 0.04;  ///< (m)
  std::string lines = "x";     ///< of the lattice
  StiffnessFormula interface_stiffness = StiffnessFormula::plane;

  [[nodiscard]] double length() const { return 2.0 * side_length + zone_length; }
  /// E' = E / (1 - ν²) (Pa).
  [[nodiscard]] double constrained_modulus() const { return young_modulus / (1.0 - poisson_ratio * poisson_ratio); }
  [[nodiscard]] double wave_speed() const { return std::sqrt(constrained_modulus() / density); }
  [[nodiscard]] Model build() const;
};

inline Packing hexagonal_packing(const Rectangle& region, double radius, const std::string& lines) {
  const auto generator = generators().create("hexagonal");
  Parameters parameters;
  generator->declare(parameters);
  for (Parameter& parameter : parameters.list()) {
    if (parameter.name == "radius") parameter.assign(radius);
    if (parameter.name == "lines") parameter.assign(lines);
  }
  return generator->generate(region, 1);
}

inline Model HybridStrip::build() const {
  Model model = empty_model({.young_modulus = young_modulus, .poisson_ratio = poisson_ratio, .density = density});
  // Material 0 makes the elements and the interface, material 1 the lattice.
  model.materials.push_back(model.materials[0]);
  model.materials[0].stiffness = interface_stiffness;
  model.materials[1].stiffness = StiffnessFormula::hexagonal;
  const auto count = [&](double size) { return static_cast<int>(std::lround(size / element_size)); };
  std::vector<double> x = even_lines(0.0, side_length, count(side_length));
  for (const double line : even_lines(side_length + zone_length, length(), count(side_length))) x.push_back(line);
  const Rectangle zone{{side_length, 0.0}, {side_length + zone_length, height}};
  add_mesh(model, {x, even_lines(0.0, height, std::max(1, count(height)))}, {zone});

  const Packing packing = hexagonal_packing(zone, radius, lines);
  const double mass = density * zone.size().x * zone.size().y * model.thickness / static_cast<double>(packing.size());
  for (const Vector& centre : packing.position) {
    add_particle(model, centre, radius);
    model.particles.material.back() = 1;
    model.particles.real_mass.back() = mass;
  }
  return model;
}

}  // namespace ligament::support
