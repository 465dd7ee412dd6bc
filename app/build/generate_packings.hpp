#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace ligament {

Rectangle rectangle_of(const ZoneTable& zone);

/// The particles of all zones, in the order of the case; in a zone in spatial order, which is that of their numbers.
/// What a generator refuses is added to the errors of the case file and thrown together.
std::vector<Packing> generate_packings(Case& input);

}  // namespace ligament
