#pragma once

#include "core/model.hpp"

namespace ligament {

/// Fills the lists of pairs that are cut: those of set-up whose branch crosses a notch. A branch goes from centre to
/// centre, to the nearest point of a facet, or to a corner. Walls are not cut from what they touch.
void find_cut_pairs(Model& model);

/// Whether a notch cuts any pair of set-up.
bool cuts_pairs(const Model& model, const Notch& notch);

}  // namespace ligament
