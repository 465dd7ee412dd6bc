#pragma once

#include <array>
#include <cstddef>

namespace ligament {

/// Of the two springs that a contact is in StiffnessSum: normal and shear.
using SpringPair = std::array<double, 2>;

/// A contact whose bond is not whole: what it has done since a time before.
struct LooseContact {
  std::size_t spring = 0;  ///< number of its normal spring among all; that of shear comes next
  SpringPair stretch{};    ///< opening and slip since then (m)
  SpringPair pull{};       ///< with what the springs pull back now (N)
  SpringPair pull_before{};
};

/// What the law of a contact answers to a stretch of its springs.
struct SpringAnswer {
  SpringPair pull{};    ///< (N)
  SpringPair secant{};  ///< see ForceProvider::add_secants() (N/m)
};

}  // namespace ligament
