#pragma once

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// Fills State::seat_contacts: the nodes of elements that lie on a wall at set-up. They press and rub against it, or
/// are tied to it, for the whole run. A node counts as a particle whose diameter H is the length of the edge that it
/// holds on the line of the wall, with L = H/2 in Eq. (33) and the material of its element.
void make_seats(const Model& model, State& state);

}  // namespace ligament
