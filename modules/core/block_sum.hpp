#pragma once

#include <algorithm>
#include <cstddef>

namespace ligament {

/// Physics and sums walk the rows of a table in blocks of this size, whatever the number of threads.
inline constexpr std::size_t block_size = 512;

/// Sum of term(i) over i in [0, count) in one fixed order: by blocks, then over blocks. Every global sum of a run goes
/// through here, so that its bits depend on nothing but the values.
template <class Term>
auto block_sum(std::size_t count, Term&& term) {
  using Value = decltype(term(std::size_t{0}));
  Value total{};
  for (std::size_t begin = 0; begin < count; begin += block_size) {
    const std::size_t end = std::min(begin + block_size, count);
    Value partial{};
    for (std::size_t i = begin; i < end; ++i) partial += term(i);
    total += partial;
  }
  return total;
}

}  // namespace ligament
