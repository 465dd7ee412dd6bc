#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>

namespace ligament::test {

/// The folder of this process, gone when it ends: the tests of one program run beside each other.
class ProcessFolder {
 public:
  ProcessFolder() : path_(std::filesystem::path(LIGAMENT_TEST_SCRATCH) / ("process_" + std::to_string(::getpid()))) {}
  ProcessFolder(const ProcessFolder&) = delete;
  ProcessFolder& operator=(const ProcessFolder&) = delete;
  ~ProcessFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// An empty folder of its own for each test.
inline std::filesystem::path scratch_folder(const std::string& name) {
  static const ProcessFolder process;
  const std::filesystem::path folder = process.path() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// While one lives, no file grows beyond `n_bytes`: writes fail half way, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t n_bytes) : former_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &former_limit_);
    const rlimit limit{n_bytes, former_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &former_limit_);
    std::signal(SIGXFSZ, former_handler_);
  }

 private:
  rlimit former_limit_{};
  void (*former_handler_)(int);
};

}  // namespace ligament::test
