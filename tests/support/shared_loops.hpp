#pragma once

#include "core/parallel.hpp"

namespace ligament::support {

/// While it lives, so many threads share every loop, however small.
class SharedLoops {
 public:
  explicit SharedLoops(int n_threads) { threads() = {.count = n_threads, .share_small_loops = true}; }
  SharedLoops(const SharedLoops&) = delete;
  SharedLoops& operator=(const SharedLoops&) = delete;
  ~SharedLoops() { threads() = {}; }
};

}  // namespace ligament::support
