#pragma once

#include "case/case.hpp"

namespace ligament {

/// Checks walls, stages of loading and the method against the rest of the case: walls have particles on one side only,
/// stages follow each other without a gap, masses and time step are what the method can do with. Adds its errors to
/// those of the case.
void check_loading(Case& input);

}  // namespace ligament
