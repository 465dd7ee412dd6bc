#include "contact/shared_bodies.hpp"

namespace ligament {

[[gnu::target_clones("avx512f", "avx2", "default")]] Index largest_row(const Index* rows, std::size_t count) {
  Index largest = -1;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, rows[i]);
  return largest;
}

}  // namespace ligament
