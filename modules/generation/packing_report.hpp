#pragma once

#include "core/generator.hpp"

namespace ligament {

/// Count, radii and area ratio (area of the discs over area of the region) of a packing.
std::vector<ReportEntry> packing_report(const Packing& packing, const Rectangle& region);

}  // namespace ligament
