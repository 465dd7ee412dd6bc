#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/closest_name.hpp"
#include "core/error.hpp"
#include "io/assembly_reading.hpp"
#include "io/hdf5_handle.hpp"

namespace ligament {
namespace {

/// An HDF5 file in memory, as far as assemblies need it.
class AssemblyReader {
 public:
  AssemblyReader(const std::string& content, const std::filesystem::path& path)
      : path_(path.string()), check_(path), file_(open(content)) {}

  /// The group of that name, or the only one there is.
  [[nodiscard]] Hdf5Handle find_group(const std::string& name) const {
    const std::vector<std::string> names = group_names();
    const bool has_name = std::find(names.begin(), names.end(), name) != names.end();
    if (!has_name && names.size() != 1) {
      complain(fmt::format("has no group '{}' (there are: {})", name, names.empty() ? "none" : quoted_list(names)));
    }
    return own(H5Gopen2(file_.get(), (has_name ? name : names[0]).c_str(), H5P_DEFAULT), H5Gclose);
  }

  /// The lengths (m) in a dataset, row by row.
  [[nodiscard]] std::vector<double> read_lengths(hid_t group, const char* name, hsize_t n_columns) const {
    if (H5Lexists(group, name, H5P_DEFAULT) <= 0) complain(fmt::format("has no dataset '{}'", name));
    const Hdf5Handle dataset = own(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
    std::vector<double> values(number_of_values(dataset.get(), name, n_columns));
    check_unit(dataset.get(), name);
    expect(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
  }

  [[noreturn]] void complain(const std::string& what) const { throw InputError(fmt::format("{}: {}", path_, what)); }

 private:
  [[nodiscard]] Hdf5Handle own(hid_t id, Hdf5Handle::Release release) const { return check_.own(id, release, "read"); }
  void expect(std::int64_t returned) const { check_.expect(returned, "read"); }

  [[nodiscard]] Hdf5Handle open(const std::string& content) const {
    constexpr std::size_t growth_in_bytes = 1 << 20;
    constexpr hbool_t on_disk = false;
    const Hdf5Handle access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    expect(H5Pset_fapl_core(access.get(), growth_in_bytes, on_disk));
    std::string copy = content;  // which HDF5 takes as a buffer that may change
    expect(H5Pset_file_image(access.get(), copy.data(), copy.size()));
    // A name that no file can have, below a file: HDF5 refuses an image under the name of one that is there.
    return own(H5Fopen((path_ + "/image").c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  }

  [[nodiscard]] std::vector<std::string> group_names() const {
    H5G_info_t info;
    expect(H5Gget_info(file_.get(), &info));
    std::vector<std::string> names;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      std::array<char, 256> name{};
      expect(
          H5Lget_name_by_idx(file_.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT));
      const Hdf5Handle object = own(H5Oopen(file_.get(), name.data(), H5P_DEFAULT), H5Oclose);
      if (H5Iget_type(object.get()) == H5I_GROUP) names.emplace_back(name.data());
    }
    return names;
  }

  [[nodiscard]] std::size_t number_of_values(hid_t dataset, const char* name, hsize_t n_columns) const {
    const Hdf5Handle space = own(H5Dget_space(dataset), H5Sclose);
    const Hdf5Handle type = own(H5Dget_type(dataset), H5Tclose);
    const int rank = n_columns == 1 ? 1 : 2;
    std::array<hsize_t, 2> shape{0, 1};
    const bool is_right = H5Tget_class(type.get()) == H5T_FLOAT && H5Sget_simple_extent_ndims(space.get()) == rank &&
                          H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr) == rank &&
                          shape[1] == n_columns;
    if (!is_right) {
      complain(fmt::format("the dataset '{}' is not a table of floating-point numbers with {} column{}", name,
                           n_columns, n_columns == 1 ? "" : "s"));
    }
    return shape[0] * shape[1];
  }

  /// A file without units is taken to be in metres.
  void check_unit(hid_t dataset, const char* name) const {
    if (H5Aexists(dataset, "unit") <= 0) return;
    const std::string unit = read_text(own(H5Aopen(dataset, "unit", H5P_DEFAULT), H5Aclose));
    if (unit != "m") complain(fmt::format("the dataset '{}' is in '{}', but must be in 'm'", name, unit));
  }

  /// Other programs write texts of variable length.
  [[nodiscard]] std::string read_text(const Hdf5Handle& attribute) const {
    const Hdf5Handle type = own(H5Aget_type(attribute.get()), H5Tclose);
    if (H5Tget_class(type.get()) != H5T_STRING) return {};
    if (H5Tis_variable_str(type.get()) > 0) {
      char* text = nullptr;
      expect(H5Aread(attribute.get(), type.get(), static_cast<void*>(&text)));
      std::string result = text == nullptr ? "" : text;
      H5free_memory(text);
      return result;
    }
    std::string text(H5Tget_size(type.get()), '\0');
    expect(H5Aread(attribute.get(), type.get(), text.data()));
    return text.substr(0, text.find('\0'));
  }

  std::string path_;
  Hdf5Checker check_;
  Hdf5Handle file_;
};

Packing read_group(const AssemblyReader& file, const std::string& zone) {
  const Hdf5Handle group = file.find_group(zone);
  const std::vector<double> position = file.read_lengths(group.get(), "position", dimension);
  Packing packing;
  packing.radius = file.read_lengths(group.get(), "radius", 1);
  if (position.size() != packing.size() * dimension) {
    file.complain(
        fmt::format("'position' has {} rows and 'radius' has {}", position.size() / dimension, packing.size()));
  }
  packing.position.resize(packing.size());
  for (std::size_t i = 0; i < position.size(); ++i) {
    set_component(packing.position[i / dimension], static_cast<int>(i % dimension), position[i]);
  }
  return packing;
}

}  // namespace

Packing read_discs_hdf5(const std::string& content, const std::filesystem::path& path, const std::string& zone) {
  try {
    return read_group(AssemblyReader(content, path), zone);
  } catch (const FileError& error) {
    // What a case names is input, whatever is wrong with it.
    throw InputError(error.what());
  }
}

}  // namespace ligament
