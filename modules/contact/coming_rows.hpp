#pragma once

#include <algorithm>
#include <array>

#include "contact/law_ranges.hpp"

namespace ligament {

/// What the step will read of the next block of a contact table. Loops over a block have all they need in the first
/// cache, and processors do not look beyond them: tables that are larger than their caches have to be asked for, a few
/// rows at a time, while the bodies of the block before are fetched.
class ComingRows {
 public:
  /// Rows that come together: one cache line of each column.
  static constexpr std::size_t at_a_time = 8;

  /// Rows of a table from this one on.
  ComingRows(const ContactTable& contacts, std::size_t row)
      : columns_{contacts.rest_distance.data(),
                 contacts.initial_gap.data(),
                 contacts.opening.data(),
                 contacts.shear_displacement.data(),
                 contacts.normal_stiffness.data(),
                 contacts.shear_stiffness.data(),
                 contacts.area.data(),
                 contacts.normal_force.data(),
                 contacts.shear_force.data()},
        row_(row),
        n_rows_(contacts.size() < smallest_table ? 0 : std::min(contact_block_size, contacts.size() - row)) {}

  /// Asks for the rows from this one of the block on. Inline: g++ drops calls of functions that only do this.
  [[gnu::always_inline]] void ask_for(std::size_t begin) const {
    if (begin >= n_rows_) return;
    for (const double* column : columns_) __builtin_prefetch(column + row_ + begin, 0, second_cache);
  }

 private:
  static constexpr int second_cache = 2;
  /// Smaller tables stay in a cache.
  static constexpr std::size_t smallest_table = 50'000;

  std::array<const double*, 9> columns_;
  std::size_t row_;
  std::size_t n_rows_;
};

}  // namespace ligament
