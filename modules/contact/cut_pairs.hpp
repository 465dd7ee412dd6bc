#pragma once

#include "core/model.hpp"

namespace ligament {

/// Fills the lists of pairs that are cut: those of set-up whose branch crosses a notch. A branch goes from centre to
/// centre, or just behind the nearest point of a facet, or behind a corner, so that a notch along the edge of elements
/// cuts. Walls are not cut from what they touch.
void find_cut_pairs(Model& model);

/// Whether a notch cuts any pair of set-up.
bool cuts_pairs(const Model& model, const Notch& notch);

/// By how much the faces of the notches between a pair stand apart (m); 0 where there is none.
double particle_gap(const Model& model, const SetupPair& pair);
double facet_gap(const Model& model, const SetupPair& pair);
double corner_gap(const Model& model, const SetupPair& pair);

}  // namespace ligament
