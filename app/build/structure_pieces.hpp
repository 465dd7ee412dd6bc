#pragma once

#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// The pieces that elements and unbroken bonds hold together. Walls hold nothing together: they are no part of the
/// structure.
class StructurePieces {
 public:
  /// Remembers which bodies belong together now.
  StructurePieces(const Model& model, const State& state);

  /// Area of the largest piece that has come off since, over that of all bodies; of what a piece falls into, the
  /// largest part stays and the others come off. 0 if all is as it was.
  [[nodiscard]] double largest_cut_off(const Model& model, const State& state) const;

 private:
  std::vector<std::size_t> pieces_;  ///< of every body at first: the lowest of its piece
  std::vector<double> areas_;        ///< of bodies, particles before nodes (m2)
};

}  // namespace ligament
