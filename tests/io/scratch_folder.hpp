#pragma once

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>

namespace ligament::test {

/// An empty folder of its own for each test.
inline std::filesystem::path scratch_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(LIGAMENT_TEST_SCRATCH) / "io" / name;
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
