#include <fmt/format.h>

#include <array>
#include <charconv>

#include "core/error.hpp"
#include "io/assembly_reading.hpp"

namespace ligament {
namespace {

constexpr std::size_t numbers_per_row = dimension + 1;

/// The text up to the next separator, which is taken away with it.
std::string_view take_until(std::string_view& rest, char separator) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

/// Files from other systems end their lines with two characters.
std::string_view take_line(std::string_view& rest) {
  std::string_view line = take_until(rest, '\n');
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The numbers of a row; false if it does not consist of that many numbers.
bool parse_row(std::string_view line, std::array<double, numbers_per_row>& numbers) {
  for (double& number : numbers) {
    const std::string_view cell = take_until(line, ',');
    const char* const end = cell.data() + cell.size();
    const auto [stopped_at, error] = std::from_chars(cell.data(), end, number);
    if (error != std::errc{} || stopped_at != end) return false;
  }
  return line.empty();
}

}  // namespace

Packing read_discs_csv(std::string_view content, const std::filesystem::path& path) {
  const std::string_view header = take_line(content);
  if (header != discs_csv_header) {
    throw InputError(fmt::format("{}: is neither HDF5 nor a CSV file with the header '{}' (it begins with '{}')",
                                 path.string(), discs_csv_header, header.substr(0, 40)));
  }
  Packing packing;
  std::array<double, numbers_per_row> numbers{};
  while (!content.empty()) {
    const std::string_view line = take_line(content);
    if (!parse_row(line, numbers)) {
      throw InputError(fmt::format("{}: row {} is '{}', not three numbers between commas", path.string(),
                                   packing.size() + 1, line.substr(0, 80)));
    }
    Vector centre;
    for (int axis = 0; axis < dimension; ++axis) set_component(centre, axis, numbers[axis]);
    packing.position.push_back(centre);
    packing.radius.push_back(numbers.back());
  }
  return packing;
}

}  // namespace ligament
