#include "io/assembly_file.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <span>

#include "io/assembly_reading.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_image.hpp"

namespace ligament {
namespace {

std::vector<double> flattened(std::span<const Vector> vectors) {
  std::vector<double> values;
  values.reserve(vectors.size() * dimension);
  for (const Vector& vector : vectors) {
    for (int axis = 0; axis < dimension; ++axis) values.push_back(component(vector, axis));
  }
  return values;
}

void add_length(const Hdf5Image& image, hid_t group, const char* name, std::span<const double> values,
                std::size_t n_columns) {
  const Hdf5Handle dataset = image.add_dataset(group, name, values, n_columns);
  image.add_attribute(dataset.get(), "unit", std::string_view("m"));
}

void add_zone(const Hdf5Image& image, const ZoneAssembly& assembly) {
  const Hdf5Handle group = image.create_group(image.file(), assembly.zone.c_str());
  add_length(image, group.get(), "position", flattened(assembly.packing.position), dimension);
  add_length(image, group.get(), "radius", assembly.packing.radius, 1);
  image.add_attribute(group.get(), "generator", std::string_view(assembly.generator));
  const std::array corners{assembly.region.from, assembly.region.to};
  const std::vector<double> region = flattened(corners);
  const std::span<const double> values(region);
  image.add_attribute(group.get(), "from_m", values.first(dimension));
  image.add_attribute(group.get(), "to_m", values.last(dimension));
  for (const ReportEntry& entry : assembly.packing.report) {
    image.add_attribute(group.get(), entry.name.c_str(), std::span<const double>(&entry.value, 1));
  }
}

}  // namespace

void write_assemblies_hdf5(const std::filesystem::path& path, const Assemblies& assemblies) {
  const Hdf5Image image(path);
  const hid_t file = image.file();
  image.add_attribute(file, "program", std::string_view("ligament"));
  image.add_attribute(file, "version", std::string_view(assemblies.program_version));
  image.add_attribute(file, "seed", std::span<const std::int64_t>(&assemblies.seed, 1));
  image.add_text(file, "case", assemblies.case_text);
  image.add_text(file, "case_resolved", assemblies.case_resolved);
  for (const ZoneAssembly& assembly : assemblies.zones) add_zone(image, assembly);
  write_atomically(path, image.bytes());
}

void write_discs_csv(const std::filesystem::path& path, const Packing& packing) {
  std::string content = fmt::format("{}\n", discs_csv_header);
  for (std::size_t i = 0; i < packing.size(); ++i) {
    for (int axis = 0; axis < dimension; ++axis) {
      fmt::format_to(std::back_inserter(content), "{},", component(packing.position[i], axis));
    }
    fmt::format_to(std::back_inserter(content), "{}\n", packing.radius[i]);
  }
  write_atomically(path, content);
}

Packing read_discs(const std::string& content, const std::filesystem::path& path, const std::string& zone) {
  constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
  return std::string_view(content).starts_with(hdf5_signature) ? read_discs_hdf5(content, path, zone)
                                                               : read_discs_csv(content, path);
}

}  // namespace ligament
