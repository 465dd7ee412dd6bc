#include "run/console.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace ligament {

Console::Console(bool quiet) : quiet_(quiet), shows_progress_(!quiet && isatty(STDOUT_FILENO) == 1) {}

void Console::open_log(const std::filesystem::path& path) { log_path_ = path; }

void Console::line(const std::string& text) {
  clear_progress();
  if (!quiet_) std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  log(text);
}

void Console::warning(const std::string& text) {
  clear_progress();
  std::fprintf(stderr, "warning: %s\n", text.c_str());
  log("warning: " + text);
}

void Console::progress(const std::string& text) {
  if (!shows_progress_) return;
  std::printf("\r\033[K%s", text.c_str());
  std::fflush(stdout);
  has_progress_ = true;
}

void Console::clear_progress() {
  if (!has_progress_) return;
  std::printf("\r\033[K");
  std::fflush(stdout);
  has_progress_ = false;
}

void Console::log(const std::string& text) {
  if (log_path_.empty()) return;
  // A log that cannot be written is no reason to stop a run.
  std::ofstream(log_path_, std::ios::app) << text << '\n';
}

}  // namespace ligament
