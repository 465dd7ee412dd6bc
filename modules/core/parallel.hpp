#pragma once

#include <cstddef>
#include <exception>
#include <mutex>

#include "core/thread_team.hpp"

/// Loops over rows that threads share. Results must not show which thread took which rows: a row writes what is its
/// own, and sums go through block_sum.
namespace ligament {

/// How many threads share a loop, and whether they also share those that are too small to gain from it (for tests).
struct Threads {
  int count = 1;
  bool share_small_loops = false;
};

/// Those of the process. Not to be changed while a loop is under way.
inline Threads& threads() {
  static Threads of_the_process;
  return of_the_process;
}

/// Bringing threads together and apart takes as long as the physics of some hundred contacts, and what a thread has
/// written is slow to read for another: loops over fewer rows are faster alone.
inline constexpr std::size_t smallest_shared_loop = 4096;

/// The same of the loops over bodies in a step: several follow each other, and go where the contacts of the bodies are,
/// of which each has two or three.
inline constexpr std::size_t smallest_shared_bodies = 2048;

/// Whether threads share a loop over so many rows.
inline bool is_shared(std::size_t count, std::size_t smallest = smallest_shared_loop) {
  return threads().count > 1 && count > 0 && (count >= smallest || threads().share_small_loops);
}

/// Calls body(begin, end) for ranges of rows that together are [0, count): one for each thread if the loop is shared,
/// else a single one, none if there are no rows. Throws what a call of the body has thrown, after all have returned.
template <class Body>
void parallel_ranges(std::size_t count, bool shared, Body&& body) {
  if (!shared) {
    if (count > 0) body(std::size_t{0}, count);
    return;
  }
  const auto n_ranges = static_cast<std::size_t>(threads().count);
  std::exception_ptr failure;
  std::mutex one_at_a_time;
  auto do_range = [&](std::size_t range) {
    try {
      const std::size_t begin = count * range / n_ranges;
      const std::size_t end = count * (range + 1) / n_ranges;
      if (begin < end) body(begin, end);
    } catch (...) {
      const std::lock_guard lock(one_at_a_time);
      failure = std::current_exception();
    }
  };
  ThreadTeam::of_the_process().share(
      threads().count,
      [](void* task, int range) { (*static_cast<decltype(do_range)*>(task))(static_cast<std::size_t>(range)); },
      &do_range);
  if (failure) std::rethrow_exception(failure);
}

template <class Body>
void parallel_ranges(std::size_t count, Body&& body) {
  parallel_ranges(count, is_shared(count), body);
}

/// The same for bodies of a step.
template <class Body>
void parallel_bodies(std::size_t count, Body&& body) {
  parallel_ranges(count, is_shared(count, smallest_shared_bodies), body);
}

}  // namespace ligament
