#pragma once

#include "core/generator.hpp"

namespace ligament {

/// Sorts the discs of a packing along strips of cells, so that neighbours in space are neighbours in memory. Bodies
/// numbered like this cut the cost of a step by two to six on large assemblies.
void sort_spatially(Packing& packing);

}  // namespace ligament
