#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ligament {

/// Where copies of files are, by the path that the case has for them.
using FileCopies = std::map<std::string, std::filesystem::path>;

/// The files that a case names besides itself. Each is read once, so that what is used, what is hashed and what a run
/// directory keeps are the same bytes.
class InputFiles {
 public:
  /// Paths are relative to `folder`, except for those of which there are copies.
  explicit InputFiles(std::filesystem::path folder, FileCopies copies = {})
      : folder_(std::move(folder)), copies_(std::move(copies)) {}

  /// Where the file of that name in the case is.
  [[nodiscard]] std::filesystem::path location(const std::string& path) const;

  /// The whole file. Throws InputError if it cannot be read.
  const std::string& content(const std::string& path);

  /// All files that were read, by their path in the case.
  [[nodiscard]] const std::map<std::string, std::string>& contents() const { return contents_; }

 private:
  std::filesystem::path folder_;
  FileCopies copies_;
  std::map<std::string, std::string> contents_;
};

}  // namespace ligament
