#include "run/signals.hpp"

#include <csignal>
#include <initializer_list>

namespace ligament {
namespace {

volatile std::sig_atomic_t stop_signal = 0;
volatile std::sig_atomic_t wants_checkpoint = 0;

extern "C" void handle_signal(int signal) {
  if (signal == SIGUSR1) {
    wants_checkpoint = 1;
  } else {
    stop_signal = signal;
  }
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = handle_signal;
  // Writes under way are to go on.
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaction(signal, &action, nullptr);
}

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

bool is_stop_requested() { return stop_signal != 0; }

Request take_request() {
  if (stop_signal == SIGINT) return Request::stop_by_interrupt;
  if (stop_signal == SIGTERM) return Request::stop_by_termination;
  if (wants_checkpoint == 0) return Request::none;
  wants_checkpoint = 0;
  return Request::checkpoint;
}

}  // namespace ligament
