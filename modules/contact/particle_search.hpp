#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "core/model.hpp"

namespace ligament {

/// The gap (m) up to which two particles count as a pair.
using PairReach = std::function<double(Index first, Index second)>;

/// Bounds of the reach of every pair (m): pairs closer than the smallest need not be asked for theirs.
struct ReachBounds {
  double smallest = -std::numeric_limits<double>::infinity();
  double largest = 0.0;
};

/// All pairs of discs whose gap at these centres is at most their reach, first < second, sorted.
std::vector<SetupPair> find_particle_pairs(std::span<const Vector> centres, std::span<const double> radii,
                                           const PairReach& reach, const ReachBounds& bounds);

}  // namespace ligament
