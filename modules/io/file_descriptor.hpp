#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace ligament {

/// Owns one POSIX file descriptor. Streams are no use for results that must survive a kill: they hide which write
/// failed and cannot flush to the disk.
class FileDescriptor {
 public:
  /// Opens `path` with the given open(2) flags; FileError names the path and the reason.
  FileDescriptor(const std::filesystem::path& path, int flags);
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

  /// Writes everything, in one write(2) unless the system takes less; FileError if it cannot.
  void write_all(std::string_view content);
  /// Reads to the end of the file.
  [[nodiscard]] std::string read_all();
  /// Cuts the file to `n_bytes`; returns false (errno is set) instead of throwing, since it also cleans up after
  /// errors.
  [[nodiscard]] bool truncate(std::size_t n_bytes) noexcept;
  /// Locks the file against other processes until it is closed or the process ends, however it ends; false if another
  /// one holds it. File systems that know no locks let everyone in.
  [[nodiscard]] bool try_lock() noexcept;
  /// Whether the file is still what its path leads to: not removed, replaced or moved since it was opened.
  [[nodiscard]] bool is_in_place() const noexcept;
  /// Flushes to the disk. File systems that cannot flush this kind of file are not an error.
  void flush_to_disk();
  /// Closes and reports what a destructor would have to keep quiet (delayed write errors of network file systems).
  void close();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Throws FileError "cannot <action> <path>: <reason of error_number>".
[[noreturn]] void throw_file_error(std::string_view action, const std::filesystem::path& path,
                                   int error_number = errno);

}  // namespace ligament
