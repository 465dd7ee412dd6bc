#pragma once

#include "case/case.hpp"

namespace ligament {

/// Checks what the tables of a case mean together: materials that exist, grid lines that ascend, zones that lie in the
/// mesh and apart from each other, formulas that hold, walls, stages and a method that fit. Throws InputError with all
/// errors.
void check_case(Case& input);

}  // namespace ligament
