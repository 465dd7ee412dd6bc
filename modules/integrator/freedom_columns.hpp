#pragma once

#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

/// The freedoms of all bodies as one column, numbered as in FreedomNumbers; prescribed ones are zero in it
/// unless it is said to be of all.
namespace ligament {

/// 1 where a freedom is free, else 0.
std::vector<double> free_mask(const Model& model);
/// Displacements, forces and u(n) - u(n-1) of all freedoms, prescribed ones too.
std::vector<double> all_displacements(const Model& model, const State& state);
std::vector<double> all_forces(const Model& model, const State& state);
std::vector<double> all_increments(const Model& model, const State& state);

std::vector<double> free_forces(const Model& model, const State& state);
/// v(n+½), or v(n-½) before velocities are updated.
std::vector<double> free_velocities(const Model& model, const State& state);
/// v(n-½).
std::vector<double> free_velocities_before(const Model& model, const State& state);
/// u(n) - u(n-1).
std::vector<double> free_increments(const Model& model, const State& state);
/// Σ a b in one fixed order.
double product(const std::vector<double>& a, const std::vector<double>& b);
/// 1 over mass or inertia.
std::vector<double> inverse_masses(const Model& model, const State& state);

/// Adds a motion of all freedoms to displacements and increments.
void move_bodies(const std::vector<double>& motion, State& state);

/// Puts displacements of all freedoms in the place of those that are there.
void set_displacements(const std::vector<double>& places, State& state);

/// Moves v(n+½) of all bodies to v(n-½), and gives the free freedoms their new one; prescribed ones keep it until a
/// constraint sets it.
void set_free_velocities(const Model& model, const std::vector<double>& velocities, State& state);

/// ½ m v(n-½) v(n+½) of prescribed freedoms (J).
double prescribed_kinetic_energy(const Model& model, const State& state);

}  // namespace ligament
