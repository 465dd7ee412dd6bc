#pragma once

#include <cmath>

#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "integrator/dynamic_relaxation.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/hybrid_strip.hpp"

/// Square hexagonal assemblies with bonds that soften along two lines and slide, strong enough to stay whole.
namespace ligament::benchmarks {

inline constexpr double lattice_radius = 0.01;
inline constexpr double lattice_skin = 0.25 * lattice_radius;

/// Side of a square that holds about this many particles.
inline Rectangle lattice_region(std::size_t n_particles) {
  const double side = lattice_radius * std::sqrt(2.0 * std::sqrt(3.0) * static_cast<double>(n_particles));
  return {{0.0, 0.0}, {side, side}};
}

inline Model lattice_model(std::size_t n_particles) {
  Model model = support::empty_model({.stiffness = StiffnessFormula::hexagonal});
  MohrCoulombBilinear bond;
  bond.tensile_strength = 1e7;
  bond.cohesion = 4e7;
  bond.friction_coefficient = 0.3;
  bond.fracture_energy_tension = 1e7;
  bond.fracture_energy_shear = 1e8;
  model.laws[support::bond_law] = {"rock.bond", std::make_shared<BatchLaw<MohrCoulombBilinear>>(bond),
                                   MohrCoulombBilinear::n_history};
  for (const Vector& centre : support::hexagonal_packing(lattice_region(n_particles), lattice_radius, "x").position) {
    support::add_particle(model, centre, lattice_radius);
  }
  return model;
}

/// A lattice that stands on its lowest line and settles under its weight, by dynamic relaxation.
inline Simulation settling_lattice(std::size_t n_particles) {
  Model model = lattice_model(n_particles);
  support::SimulationChoice choice{.skin = lattice_skin, .time_step = {}, .gravity = Vector{0.0, -9.81}};
  choice.damping = std::make_unique<DynamicRelaxation>();
  for (Index row = 0; row < static_cast<Index>(model.particles.size()); ++row) {
    if (model.particles.position[row].y > 1.1 * lattice_radius) continue;
    for (const PrescribedFreedom& freedom : support::held_particle(row)) choice.prescribed.push_back(freedom);
  }
  return support::make_simulation(std::move(model), std::move(choice));
}

}  // namespace ligament::benchmarks
