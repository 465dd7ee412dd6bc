#include "io/atomic_file.hpp"

#include <fcntl.h>

#include <cstdio>
#include <system_error>
#include <utility>

#include "io/file_descriptor.hpp"

namespace ligament {
namespace {

/// Removes the unfinished file, which after a successful rename is no longer there.
class PartGuard {
 public:
  explicit PartGuard(std::filesystem::path part) : part_(std::move(part)) {}
  PartGuard(const PartGuard&) = delete;
  PartGuard& operator=(const PartGuard&) = delete;
  ~PartGuard() {
    std::error_code already_failing;
    std::filesystem::remove(part_, already_failing);
  }

 private:
  std::filesystem::path part_;
};

void flush_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  FileDescriptor(folder, O_RDONLY | O_DIRECTORY).flush_to_disk();
}

void rename_into_place(const std::filesystem::path& part, const std::filesystem::path& final_path) {
  if (std::rename(part.c_str(), final_path.c_str()) != 0) throw_file_error("write", final_path);
  // The rename itself is on the disk only when the folder is.
  flush_folder_of(final_path);
}

}  // namespace

std::filesystem::path part_path(const std::filesystem::path& final_path) {
  std::filesystem::path part = final_path;
  part += ".part";
  return part;
}

void write_atomically(const std::filesystem::path& final_path, std::string_view content) {
  write_atomically(final_path, {content});
}

void write_atomically(const std::filesystem::path& final_path, std::initializer_list<std::string_view> pieces) {
  const std::filesystem::path part = part_path(final_path);
  FileDescriptor file(part, O_WRONLY | O_CREAT | O_TRUNC);
  PartGuard guard(part);
  for (const std::string_view piece : pieces) file.write_all(piece);
  file.flush_to_disk();
  file.close();
  rename_into_place(part, final_path);
}

void publish(const std::filesystem::path& part, const std::filesystem::path& final_path) {
  PartGuard guard(part);
  FileDescriptor(part, O_RDWR).flush_to_disk();
  rename_into_place(part, final_path);
}

std::string read_file(const std::filesystem::path& path) { return FileDescriptor(path, O_RDONLY).read_all(); }

}  // namespace ligament
