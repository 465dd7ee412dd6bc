#pragma once

#include <span>

#include "core/vector.hpp"

namespace ligament {

/// For every body the places where a list names it, in the order of the list: what a body needs to add up, in the same
/// order as a walk through the list would, the forces that stand there.
struct Occurrences {
  Field<Index> begin{0};  ///< of each body in `places`; one entry more than bodies
  Field<Index> places;    ///< in the list

  [[nodiscard]] std::span<const Index> of(std::size_t body) const {
    return std::span(places).subspan(begin[body], begin[body + 1] - begin[body]);
  }
};

/// Entries of the list below 0 are no bodies.
Occurrences find_occurrences(std::span<const Index> list, std::size_t n_bodies);

}  // namespace ligament
