#include "io/field_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace ligament {
namespace {

std::string file_name(std::string_view group_name, std::int64_t step) {
  return fmt::format("{}_{:06}.hdf", group_name, step);
}

/// The step in the name of one of the group's field files, finished or not.
std::optional<std::int64_t> step_in_name(std::string_view name, std::string_view group_name) {
  if (name.ends_with(".part")) name.remove_suffix(std::string_view(".part").size());
  if (!name.starts_with(group_name)) return std::nullopt;
  std::int64_t step = 0;
  const std::string_view rest = name.substr(group_name.size());
  if (!rest.starts_with('_')) return std::nullopt;
  std::from_chars(rest.data() + 1, rest.data() + rest.size(), step);
  if (name != file_name(group_name, step)) return std::nullopt;
  return step;
}

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw FileError(fmt::format("cannot remove {}: {}", path.string(), error.message()));
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    paths.push_back(entry->path());
  }
  if (error) throw FileError(fmt::format("cannot list {}: {}", folder.string(), error.message()));
  return paths;
}

}  // namespace

FieldSeries::FieldSeries(std::filesystem::path folder, std::string group_name)
    : folder_(std::move(folder)), group_name_(std::move(group_name)) {}

std::filesystem::path FieldSeries::file_of(std::int64_t step) const { return folder_ / file_name(group_name_, step); }

void FieldSeries::add(std::int64_t step, double time_s, std::string image) {
  const std::int64_t last = !waiting_.empty() ? waiting_.back().stamp.step : stamps_.empty() ? -1 : stamps_.back().step;
  if (step <= last) {
    throw std::logic_error(fmt::format("fields '{}' of step {} after those of {}", group_name_, step, last));
  }
  waiting_.push_back({{step, time_s}, std::move(image)});
}

void FieldSeries::flush() {
  while (!waiting_.empty()) {
    const WaitingFile& next = waiting_.front();
    write_atomically(file_of(next.stamp.step), next.image);
    is_listed_ = false;
    stamps_.push_back(next.stamp);
    waiting_.pop_front();
  }
  if (is_listed_) return;
  write_list();
  is_listed_ = true;
}

std::size_t FieldSeries::n_waiting() const {
  return std::accumulate(waiting_.begin(), waiting_.end(), std::size_t{0},
                         [](std::size_t sum, const WaitingFile& file) { return sum + file.image.size(); });
}

void FieldSeries::resume(std::int64_t last_step) {
  stamps_.clear();
  for (const auto& path : files_in(folder_)) {
    const auto step = step_in_name(path.filename().string(), group_name_);
    if (!step) continue;
    if (*step > last_step || path.extension() == ".part") {
      remove_file(path);
    } else {
      stamps_.push_back({*step, read_field_stamp(path).time_s});
    }
  }
  std::sort(stamps_.begin(), stamps_.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  write_list();
}

void FieldSeries::write_list() const {
  std::string list = "{\"file-series-version\": \"1.0\", \"files\": [";
  std::string_view separator = "\n";
  for (const FieldStamp& stamp : stamps_) {
    list += fmt::format("{}{{\"name\": \"{}\", \"time\": {}, \"step\": {}}}", separator,
                        file_name(group_name_, stamp.step), stamp.time_s, stamp.step);
    separator = ",\n";
  }
  list += "\n]}\n";
  write_atomically(folder_ / (group_name_ + ".hdf.series"), list);
}

}  // namespace ligament
