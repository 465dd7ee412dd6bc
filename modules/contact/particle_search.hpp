#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/model.hpp"

namespace ligament {

/// The gap (m) up to which two particles count as a pair.
using PairReach = std::function<double(Index first, Index second)>;

/// All pairs of discs whose gap at these centres is at most their reach, first < second, sorted. `largest_reach` bounds
/// the reach of every pair.
std::vector<SetupPair> find_particle_pairs(std::span<const Vector> centres, std::span<const double> radii,
                                           const PairReach& reach, double largest_reach);

}  // namespace ligament
