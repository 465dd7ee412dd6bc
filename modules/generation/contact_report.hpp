#pragma once

#include "core/generator.hpp"

namespace ligament {

/// How the discs of a packing touch. A contact is a pair whose gap is at most `detection_gap` times the sum of its
/// radii; overlaps are told over that sum, so that 0.1 is an overlap by a tenth of r1 + r2.
///
/// `contact_anisotropy` is the difference F1 - F2 of the principal values of the fabric tensor F = mean of n ⊗ n over
/// all contact directions n: sqrt((Fxx - Fyy)² + 4 Fxy²). It is 0 if all directions are alike and 1 if there is only
/// one; N directions drawn at random give about 1/√N. All of it is 0 if there are no contacts.
std::vector<ReportEntry> contact_report(const Packing& packing, double detection_gap);

}  // namespace ligament
