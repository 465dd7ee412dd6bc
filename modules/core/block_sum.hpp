#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/parallel.hpp"

namespace ligament {

/// Physics and sums walk the rows of a table in blocks of this size, whatever the number of threads.
inline constexpr std::size_t block_size = 512;

/// Sum of partial(begin, end) over the blocks of the rows [0, count), in their order. Threads share the blocks if told
/// to.
template <class Partial>
auto sum_of_blocks(std::size_t count, bool shared, Partial&& partial) {
  using Value = decltype(partial(std::size_t{0}, std::size_t{0}));
  const auto of_block = [&](std::size_t block) {
    return partial(block * block_size, std::min((block + 1) * block_size, count));
  };
  const std::size_t n_blocks = (count + block_size - 1) / block_size;
  Value total{};
  if (!shared) {
    for (std::size_t block = 0; block < n_blocks; ++block) total += of_block(block);
    return total;
  }
  std::vector<Value> partials(n_blocks);
  parallel_ranges(n_blocks, true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) partials[block] = of_block(block);
  });
  for (const Value& sum : partials) total += sum;
  return total;
}

/// The same, shared where that is faster.
template <class Partial>
auto sum_of_blocks(std::size_t count, Partial&& partial) {
  return sum_of_blocks(count, is_shared(count), partial);
}

/// The same over bodies of a step.
template <class Partial>
auto sum_of_body_blocks(std::size_t count, Partial&& partial) {
  return sum_of_blocks(count, is_shared(count, smallest_shared_bodies), partial);
}

/// Sum of term(i) over i in [0, count) in one fixed order: by blocks, then over blocks. Every global sum of a run goes
/// through here, so that its bits depend on nothing but the values.
template <class Term>
auto block_sum(std::size_t count, Term&& term) {
  using Value = decltype(term(std::size_t{0}));
  return sum_of_blocks(count, [&](std::size_t begin, std::size_t end) {
    Value sum{};
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    return sum;
  });
}

}  // namespace ligament
