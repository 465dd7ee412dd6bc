#include "ensemble/process_pool.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "core/error.hpp"

namespace ligament {
namespace {

/// This executable, even if a newer one has taken its place on the disk.
constexpr const char* own_executable = "/proc/self/exe";
constexpr int status_of_missing_program = 127;

/// In the child process; never returns.
[[noreturn]] void become_program(const std::vector<char*>& arguments, int messages, const sigset_t& mask,
                                 pid_t parent) {
  // A run without the ensemble around it is to write its checkpoint and stop, so that the next call finds it at rest.
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (::getppid() == parent && nothing >= 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
      ::dup2(nothing, STDOUT_FILENO) >= 0 && ::dup2(messages, STDERR_FILENO) >= 0) {
    ::sigprocmask(SIG_SETMASK, &mask, nullptr);
    ::execv(own_executable, arguments.data());
  }
  ::_exit(status_of_missing_program);
}

std::string content_of(std::FILE* file) {
  std::rewind(file);
  std::string content;
  std::array<char, 4096> piece{};
  while (const std::size_t n = std::fread(piece.data(), 1, piece.size(), file)) content.append(piece.data(), n);
  return content;
}

}  // namespace

ProcessPool::ProcessPool() {
  sigemptyset(&watched_);
  for (const int signal : {SIGCHLD, SIGINT, SIGTERM, SIGUSR1}) sigaddset(&watched_, signal);
  // Who ignores its children cannot wait for them.
  std::signal(SIGCHLD, SIG_DFL);
  ::sigprocmask(SIG_BLOCK, &watched_, &former_mask_);
}

ProcessPool::~ProcessPool() {
  pass_on(SIGTERM);
  for (const Process& process : running_) ::waitpid(process.id, nullptr, 0);
  ::sigprocmask(SIG_SETMASK, &former_mask_, nullptr);
}

void ProcessPool::start(std::size_t number, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"ligament"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  File messages(std::tmpfile());
  if (!messages) throw FileError("no temporary file for the messages of a run could be made");
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw FileError("no process for a run could be started");
  if (child == 0) become_program(pointers, ::fileno(messages.get()), former_mask_, parent);
  running_.push_back({number, child, std::move(messages)});
}

ProcessPool::Ended ProcessPool::wait_for_one() {
  while (true) {
    for (auto process = running_.begin(); process != running_.end(); ++process) {
      int status = 0;
      if (::waitpid(process->id, &status, WNOHANG) != process->id) continue;
      constexpr int code_of_signals = 128;
      const int code = WIFEXITED(status) ? WEXITSTATUS(status) : code_of_signals + WTERMSIG(status);
      Ended ended{process->number, code, content_of(process->messages.get())};
      running_.erase(process);
      return ended;
    }
    take_signal();
  }
}

void ProcessPool::take_signal() {
  const int signal = ::sigwaitinfo(&watched_, nullptr);
  if (signal < 0 || signal == SIGCHLD) return;
  if (signal != SIGUSR1) stop_signal_ = signal;
  pass_on(signal);
}

void ProcessPool::pass_on(int signal) const {
  for (const Process& process : running_) ::kill(process.id, signal);
}

}  // namespace ligament
