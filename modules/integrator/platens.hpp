#pragma once

#include "core/model.hpp"
#include "core/state.hpp"
#include "core/stiffness_bounds.hpp"

/// Platens are rigid segments: with u and θ of the middle, an end at r from it has u + θ × r, and what the end feels
/// the middle feels as a force and a moment. Both maps are one matrix and its transpose, so that no energy is lost.
namespace ligament {

/// Displacements and increments of the ends from those of the middles.
void place_platen_ends(const Model& model, State& state);

/// Takes the forces off the ends, keeps them in State::platens, and adds them to the middles.
void pass_on_platen_forces(const Model& model, State& state);

/// Force (N) that holds or moves a node of an element, of a wall or of a platen: its reaction, or what the middle of
/// the platen gives to its end.
Vector holding_force(const Model& model, const State& state, Index node);

/// The same for the stiffness that the ends feel.
void pass_on_platen_stiffness(const Model& model, StiffnessBounds& bounds);

}  // namespace ligament
