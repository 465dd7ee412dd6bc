#include <doctest/doctest.h>

#include <chrono>
#include <vector>

#include "core/thread_team.hpp"
#include "support/shared_loops.hpp"

using namespace ligament;
using support::SharedLoops;

namespace {

/// How often each range of a task was done.
std::vector<int> visits_of(ThreadTeam& team, int n_ranges) {
  std::vector<int> visits(n_ranges, 0);
  team.share(
      n_ranges, [](void* task, int range) { ++(*static_cast<std::vector<int>*>(task))[range]; }, &visits);
  return visits;
}

}  // namespace

TEST_SUITE_BEGIN("threads");

TEST_CASE("a team does every range of a task once, whatever teams the tasks before asked for") {
  ThreadTeam team;
  for (const int n_ranges : {2, 5, 1, 3, 9, 2}) CHECK(visits_of(team, n_ranges) == std::vector<int>(n_ranges, 1));
}

TEST_CASE("members that look for work and those that sleep both hear of the next task") {
  ThreadTeam team;
  for (int i = 0; i < 2000; ++i) REQUIRE(visits_of(team, 2) == std::vector<int>{1, 1});
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(visits_of(team, 2) == std::vector<int>{1, 1});
  // More than any machine of ours has processors: these do not look, they sleep at once.
  for (int i = 0; i < 20; ++i) REQUIRE(visits_of(team, 300) == std::vector<int>(300, 1));
}

TEST_CASE("a loop inside of a shared loop stays in its thread") {
  const SharedLoops shared(2);
  std::vector<std::vector<std::thread::id>> ids(2, std::vector<std::thread::id>(6));
  parallel_ranges(2, [&](std::size_t outer, std::size_t) {
    parallel_ranges(6, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ids[outer][i] = std::this_thread::get_id();
    });
  });
  CHECK(ids[0] == std::vector<std::thread::id>(6, ids[0].front()));
  CHECK(ids[1] == std::vector<std::thread::id>(6, ids[1].front()));
  CHECK(ids[0].front() != ids[1].front());
}

TEST_SUITE_END();
