#pragma once

#include <filesystem>
#include <string>

namespace ligament {

/// Where a run tells what it does: its log, and the terminal unless it is to be quiet. Warnings always reach the
/// terminal. Control characters are written to terminals only.
class Console {
 public:
  explicit Console(bool quiet);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console() { clear_progress(); }

  /// Also writes all that follows to the end of this file.
  void open_log(const std::filesystem::path& path);

  void line(const std::string& text);
  void warning(const std::string& text);
  /// For the log alone.
  void log(const std::string& text);
  /// Replaces the line that shows how far the run is.
  void progress(const std::string& text);
  [[nodiscard]] bool shows_progress() const { return shows_progress_; }

 private:
  void clear_progress();

  bool quiet_;
  bool shows_progress_;
  bool has_progress_ = false;
  std::filesystem::path log_path_;
};

}  // namespace ligament
