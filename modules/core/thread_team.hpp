#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace ligament {

/// Threads that stand by to share loops. A loop of a step lasts some microseconds and the next one follows at once: who
/// waits looks again and again for a while, which is the fastest way to learn of it, then sleeps.
class ThreadTeam {
 public:
  /// What a member does of a task: the range with this number.
  using Task = void (*)(void* task, int range);

  /// That of the process; its threads start when they are first needed.
  static ThreadTeam& of_the_process();

  ThreadTeam() = default;
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  /// Does all ranges of a task, each in its own thread, the first one in that of the caller; returns when all are done.
  /// A member that calls does them one after the other. The task must not throw.
  /// Throws std::system_error if a thread cannot start.
  void share(int n_ranges, Task do_range, void* task);

 private:
  /// A thread, and how often it has been asked for a range and has done one. They are far enough apart to share no
  /// cache line.
  struct alignas(64) Member {
    std::atomic<std::uint32_t> n_asked = 0;
    alignas(64) std::atomic<std::uint32_t> n_done = 0;
    std::thread thread;
  };

  void grow(int n_members);
  void stand_by(Member& member, int range);

  std::vector<std::unique_ptr<Member>> members_;
  std::atomic<int> n_looks_ = 0;  ///< how often a waiting thread looks before it sleeps
  Task do_range_ = nullptr;       ///< null: the team breaks up
  void* task_ = nullptr;
};

}  // namespace ligament
