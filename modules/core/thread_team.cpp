#include "core/thread_team.hpp"

namespace ligament {
namespace {

/// Whether this thread is doing a range of a task.
thread_local bool is_busy = false;

/// How many there are for the process; to ask takes as long as a small loop.
int n_processors() {
  static const auto number = static_cast<int>(std::thread::hardware_concurrency());
  return number;
}

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until a counter is no longer at this number, and looks so often before it sleeps.
void wait_beyond(const std::atomic<std::uint32_t>& counter, std::uint32_t number, int n_looks) {
  for (int look = 0; look < n_looks; ++look) {
    if (counter.load(std::memory_order_acquire) != number) return;
    pause();
  }
  counter.wait(number, std::memory_order_acquire);
}

void advance(std::atomic<std::uint32_t>& counter) {
  counter.fetch_add(1);
  counter.notify_one();
}

}  // namespace

ThreadTeam& ThreadTeam::of_the_process() {
  static ThreadTeam team;
  return team;
}

ThreadTeam::~ThreadTeam() {
  do_range_ = nullptr;
  for (auto& member : members_) advance(member->n_asked);
  for (auto& member : members_) member->thread.join();
}

void ThreadTeam::share(int n_ranges, Task do_range, void* task) {
  if (is_busy) {
    for (int range = 0; range < n_ranges; ++range) do_range(task, range);
    return;
  }
  grow(n_ranges - 1);
  do_range_ = do_range;
  task_ = task;
  is_busy = true;
  for (int range = 1; range < n_ranges; ++range) advance(members_[range - 1]->n_asked);
  do_range(task, 0);
  for (int range = 1; range < n_ranges; ++range) {
    const Member& member = *members_[range - 1];
    const std::uint32_t n_asked = member.n_asked.load(std::memory_order_relaxed);
    while (member.n_done.load(std::memory_order_acquire) != n_asked)
      wait_beyond(member.n_done, n_asked - 1, n_looks_.load(std::memory_order_relaxed));
  }
  is_busy = false;
}

void ThreadTeam::grow(int n_members) {
  // choice: about a millisecond of looking, many times what it takes to wake up: else all would sleep and wake in
  // turns. With more threads than processors those that look would only hold up the others.
  constexpr int about_a_millisecond = 50'000;
  const bool is_crowded = n_members + 1 > n_processors();
  n_looks_ = is_crowded ? 0 : about_a_millisecond;
  members_.reserve(n_members);
  for (auto range = static_cast<int>(members_.size()) + 1; range <= n_members; ++range) {
    auto member = std::make_unique<Member>();
    member->thread = std::thread([this, &its = *member, range] { stand_by(its, range); });
    members_.push_back(std::move(member));
  }
}

void ThreadTeam::stand_by(Member& member, int range) {
  is_busy = true;
  for (std::uint32_t n_done = 0;;) {
    wait_beyond(member.n_asked, n_done, n_looks_.load(std::memory_order_relaxed));
    if (do_range_ == nullptr) return;
    do_range_(task_, range);
    ++n_done;
    advance(member.n_done);
  }
}

}  // namespace ligament
