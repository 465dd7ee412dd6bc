#include "case/input_files.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace ligament {

std::filesystem::path InputFiles::location(const std::string& path) const {
  const auto copy = copies_.find(path);
  return copy != copies_.end() ? copy->second : folder_ / path;
}

const std::string& InputFiles::content(const std::string& path) {
  if (const auto known = contents_.find(path); known != contents_.end()) return known->second;
  if (path.empty()) throw InputError("'path' is empty: it names no file");
  const std::filesystem::path place = location(path);
  if (!std::filesystem::exists(place)) throw InputError(fmt::format("{}: there is no such file", place.string()));
  if (!std::filesystem::is_regular_file(place)) throw InputError(fmt::format("{}: is no file", place.string()));
  try {
    return contents_[path] = read_file(place);
  } catch (const FileError& error) {
    contents_.erase(path);
    throw InputError(error.what());
  }
}

}  // namespace ligament
