#include <doctest/doctest.h>

#include <cmath>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/block_sum.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using support::SharedLoops;

TEST_SUITE_BEGIN("threads");

TEST_CASE("ranges of threads cover every row once") {
  for (const int n_threads : {1, 2, 3, 8}) {
    const SharedLoops shared(n_threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<int> visits(count, 0);
      parallel_ranges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      CHECK(visits == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("a shared loop has as many ranges as threads and a small one a single range") {
  std::mutex mutex;
  int n_ranges = 0;
  const auto count_range = [&](std::size_t, std::size_t) {
    const std::lock_guard lock(mutex);
    ++n_ranges;
  };
  const auto count_ranges = [&](std::size_t count) {
    n_ranges = 0;
    parallel_ranges(count, count_range);
    return n_ranges;
  };
  const auto count_body_ranges = [&](std::size_t count) {
    n_ranges = 0;
    parallel_bodies(count, count_range);
    return n_ranges;
  };
  threads() = {.count = 3};
  CHECK(count_ranges(smallest_shared_loop) == 3);
  CHECK(count_ranges(smallest_shared_loop - 1) == 1);
  CHECK(count_body_ranges(smallest_shared_bodies) == 3);
  CHECK(count_body_ranges(smallest_shared_bodies - 1) == 1);
  threads() = {};
  CHECK(count_ranges(smallest_shared_loop) == 1);
}

TEST_CASE("threads really share a loop") {
  const SharedLoops shared(2);
  std::vector<std::thread::id> ids(2);
  parallel_ranges(2, [&](std::size_t begin, std::size_t) { ids[begin] = std::this_thread::get_id(); });
  CHECK(ids[0] != ids[1]);
}

TEST_CASE("what a thread throws reaches the caller and the others finish their rows") {
  const SharedLoops shared(3);
  std::vector<int> visits(3, 0);
  const auto loop = [&] {
    parallel_ranges(3, [&](std::size_t begin, std::size_t) {
      ++visits[begin];
      if (begin == 1) throw std::runtime_error("row 1");
    });
  };
  CHECK_THROWS_WITH_AS(loop(), "row 1", std::runtime_error);
  CHECK(visits == std::vector<int>{1, 1, 1});
}

TEST_CASE("sums have the same bits for every number of threads") {
  const auto term = [](std::size_t i) {
    return std::sin(1.7 * static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 13));
  };
  for (const std::size_t count : {1u, 511u, 513u, 5000u, 20000u}) {
    const double alone = block_sum(count, term);
    for (const int n_threads : {2, 3, 8}) {
      const SharedLoops shared(n_threads);
      CHECK(block_sum(count, term) == alone);
    }
  }
}

TEST_SUITE_END();
