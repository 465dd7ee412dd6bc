#pragma once

#include <cstddef>

#include "core/model.hpp"
#include "core/rectangle.hpp"
#include "core/state.hpp"
#include "core/tensor.hpp"

/// Means over the particles of a rectangle.
namespace ligament {

/// Mean stress (Pa) of the particles in a rectangle: σ = -1/(area t) Σ F_C ⊗ l over the contacts between particles, of
/// whose branch l from centre to centre the part inside counts (Love's formula).
SymmetricTensor mean_stress(const Model& model, const State& state, const Rectangle& region);

/// Strain of the displacement field u = u0 + G x that fits the particles with centres at rest in a rectangle best, by
/// least squares.
SymmetricTensor mean_strain(const Model& model, const State& state, const Rectangle& region);

/// Number of particles with centres at rest in a rectangle; mean_strain() needs three that are not in line.
std::size_t count_particles(const Model& model, const Rectangle& region);

}  // namespace ligament
