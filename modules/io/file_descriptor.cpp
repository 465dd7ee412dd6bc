#include "io/file_descriptor.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

#include "core/error.hpp"

namespace ligament {

void throw_file_error(std::string_view action, const std::filesystem::path& path, int error_number) {
  throw FileError(fmt::format("cannot {} {}: {}", action, path.string(), std::strerror(error_number)));
}

FileDescriptor::FileDescriptor(const std::filesystem::path& path, int flags) : path_(path) {
  constexpr int readable_by_umask = 0666;
  do {
    descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, readable_by_umask);
  } while (descriptor_ < 0 && errno == EINTR);
  if (descriptor_ < 0) throw_file_error((flags & O_CREAT) != 0 ? "create" : "open", path);
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileDescriptor::write_all(std::string_view content) {
  while (!content.empty()) {
    const ssize_t n_written = ::write(descriptor_, content.data(), content.size());
    if (n_written < 0 && errno == EINTR) continue;
    if (n_written < 0) throw_file_error("write", path_);
    content.remove_prefix(static_cast<std::size_t>(n_written));
  }
}

std::string FileDescriptor::read_all() {
  std::string content;
  std::array<char, 1 << 16> buffer;
  while (true) {
    const ssize_t n_read = ::read(descriptor_, buffer.data(), buffer.size());
    if (n_read < 0 && errno == EINTR) continue;
    if (n_read < 0) throw_file_error("read", path_);
    if (n_read == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(n_read));
  }
}

bool FileDescriptor::truncate(std::size_t n_bytes) noexcept {
  return ::ftruncate(descriptor_, static_cast<off_t>(n_bytes)) == 0;
}

bool FileDescriptor::try_lock() noexcept {
  return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

bool FileDescriptor::is_in_place() const noexcept {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor_, &opened) == 0 && ::stat(path_.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

void FileDescriptor::flush_to_disk() {
  while (::fsync(descriptor_) != 0) {
    if (errno == EINVAL || errno == EROFS || errno == ENOTSUP) return;
    if (errno != EINTR) throw_file_error("flush", path_);
  }
}

void FileDescriptor::close() {
  const int result = ::close(std::exchange(descriptor_, -1));
  if (result != 0 && errno != EINTR) throw_file_error("close", path_);
}

}  // namespace ligament
