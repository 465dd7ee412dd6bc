#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ligament {

/// Processes of this same executable, several at a time; what one of them does to itself harms no other. While a pool
/// lives, SIGINT, SIGTERM and SIGUSR1 of this process are passed on to all of them; they stop when this process dies.
class ProcessPool {
 public:
  /// A process that has ended.
  struct Ended {
    std::size_t number = 0;
    int code = 0;          ///< exit code; 128 + signal if a signal has killed it
    std::string messages;  ///< its standard error
  };

  ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;
  ~ProcessPool();

  /// Starts the executable with these arguments, its standard output thrown away. FileError if the system has no room
  /// for another process. `number` is what Ended tells it by.
  void start(std::size_t number, const std::vector<std::string>& arguments);
  [[nodiscard]] std::size_t n_running() const { return running_.size(); }
  /// Waits until one of the running processes ends.
  Ended wait_for_one();
  /// SIGINT or SIGTERM once one has come; else 0.
  [[nodiscard]] int stop_signal() const { return stop_signal_; }

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;
  struct Process {
    std::size_t number = 0;
    pid_t id = 0;
    File messages;
  };

  void pass_on(int signal) const;
  /// Acts on the next signal; waits for it.
  void take_signal();

  std::vector<Process> running_;
  sigset_t watched_{};
  sigset_t former_mask_{};
  int stop_signal_ = 0;
};

}  // namespace ligament
