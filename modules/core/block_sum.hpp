#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/parallel.hpp"

namespace ligament {

/// Physics and sums walk the rows of a table in blocks of this size, whatever the number of threads.
inline constexpr std::size_t block_size = 512;

/// Sum of term(i) over i in [0, count) in one fixed order: by blocks, then over blocks. Every global sum of a run goes
/// through here, so that its bits depend on nothing but the values. Threads share the blocks.
template <class Term>
auto block_sum(std::size_t count, Term&& term) {
  using Value = decltype(term(std::size_t{0}));
  const auto partial = [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * block_size, count);
    Value sum{};
    for (std::size_t i = block * block_size; i < end; ++i) sum += term(i);
    return sum;
  };
  const std::size_t n_blocks = (count + block_size - 1) / block_size;
  Value total{};
  if (!is_shared(count)) {
    for (std::size_t block = 0; block < n_blocks; ++block) total += partial(block);
    return total;
  }
  std::vector<Value> partials(n_blocks);
  parallel_ranges(n_blocks, true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) partials[block] = partial(block);
  });
  for (const Value& sum : partials) total += sum;
  return total;
}

}  // namespace ligament
