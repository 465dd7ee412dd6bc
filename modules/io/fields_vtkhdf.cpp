#include "io/fields_vtkhdf.hpp"

#include <fmt/core.h>

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

#include "io/atomic_file.hpp"
#include "io/hdf5_handle.hpp"

namespace ligament {
namespace {

constexpr auto write_action = "write";
constexpr auto read_action = "read";

hid_t stored_type(const double*) { return H5T_IEEE_F64LE; }
hid_t stored_type(const std::int64_t*) { return H5T_STD_I64LE; }
hid_t stored_type(const std::uint8_t*) { return H5T_STD_U8LE; }
hid_t memory_type(const double*) { return H5T_NATIVE_DOUBLE; }
hid_t memory_type(const std::int64_t*) { return H5T_NATIVE_INT64; }
hid_t memory_type(const std::uint8_t*) { return H5T_NATIVE_UINT8; }

std::size_t points_per_cell(CellType type) {
  switch (type) {
    case CellType::vertex:
      return 1;
    case CellType::line:
      return 2;
    case CellType::quad:
      return 4;
  }
  throw std::logic_error("unknown shape of cells");
}

/// Builds a file in memory: HDF5 keeps data back until it closes a file, and does not recover from a disk that is full
/// by then, so its own files cannot be written reliably.
class VtkhdfImage {
 public:
  explicit VtkhdfImage(const std::filesystem::path& path)
      : check_(path),
        file_(create_file(path)),
        root_(create_group(file_.get(), "VTKHDF")),
        point_data_(create_group(root_.get(), "PointData")),
        cell_data_(create_group(root_.get(), "CellData")) {}

  [[nodiscard]] hid_t root() const { return root_.get(); }
  [[nodiscard]] hid_t point_data() const { return point_data_.get(); }
  [[nodiscard]] hid_t cell_data() const { return cell_data_.get(); }

  /// Adds a list of values, or a table with rows of `n_columns` if that is more than one.
  template <class Value>
  Hdf5Handle add_dataset(hid_t parent, const char* name, std::span<const Value> values, std::size_t n_columns = 1) {
    const std::array<hsize_t, 2> shape{values.size() / n_columns, n_columns};
    const Hdf5Handle space = own(H5Screate_simple(n_columns == 1 ? 1 : 2, shape.data(), nullptr), H5Sclose);
    const Hdf5Handle properties = without_times(H5P_DATASET_CREATE);
    Hdf5Handle dataset = own(
        H5Dcreate2(parent, name, stored_type(values.data()), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
        H5Dclose);
    expect(H5Dwrite(dataset.get(), memory_type(values.data()), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return dataset;
  }

  template <class Value>
  void add_attribute(hid_t object, const char* name, std::span<const Value> values) {
    const hsize_t length = values.size();
    const Hdf5Handle space =
        length == 1 ? own(H5Screate(H5S_SCALAR), H5Sclose) : own(H5Screate_simple(1, &length, nullptr), H5Sclose);
    write_attribute(object, name, stored_type(values.data()), memory_type(values.data()), space, values.data());
  }

  /// ParaView wants fixed-length ASCII without a terminator.
  void add_attribute(hid_t object, const char* name, std::string_view text) {
    const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
    const Hdf5Handle type = own(H5Tcopy(H5T_C_S1), H5Tclose);
    expect(H5Tset_size(type.get(), padded.size()));
    expect(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
    write_attribute(object, name, type.get(), type.get(), own(H5Screate(H5S_SCALAR), H5Sclose), padded.data());
  }

  [[nodiscard]] std::string bytes() {
    expect(H5Fflush(file_.get(), H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
    expect(size);
    std::string image(static_cast<std::size_t>(size), '\0');
    expect(H5Fget_file_image(file_.get(), image.data(), image.size()));
    return image;
  }

 private:
  Hdf5Handle own(hid_t id, Hdf5Handle::Release release) const { return check_.own(id, release, write_action); }
  void expect(std::int64_t returned) const { check_.expect(returned, write_action); }

  /// Object times would make the bytes depend on the clock on the wall.
  Hdf5Handle without_times(hid_t property_class) const {
    Hdf5Handle properties = own(H5Pcreate(property_class), H5Pclose);
    expect(H5Pset_obj_track_times(properties.get(), false));
    return properties;
  }

  Hdf5Handle create_file(const std::filesystem::path& path) const {
    constexpr std::size_t growth_in_bytes = 1 << 20;
    constexpr hbool_t on_disk = false;
    const Hdf5Handle access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    expect(H5Pset_fapl_core(access.get(), growth_in_bytes, on_disk));
    const Hdf5Handle creation = without_times(H5P_FILE_CREATE);
    return own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
  }

  Hdf5Handle create_group(hid_t parent, const char* name) const {
    const Hdf5Handle creation = without_times(H5P_GROUP_CREATE);
    return own(H5Gcreate2(parent, name, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
  }

  void write_attribute(hid_t object, const char* name, hid_t stored, hid_t in_memory, const Hdf5Handle& space,
                       const void* values) const {
    const Hdf5Handle attribute = own(H5Acreate2(object, name, stored, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    expect(H5Awrite(attribute.get(), in_memory, values));
  }

  Hdf5Checker check_;
  Hdf5Handle file_;
  Hdf5Handle root_;
  Hdf5Handle point_data_;
  Hdf5Handle cell_data_;
};

template <class Value>
std::span<const Value> one(const Value& value) {
  return {&value, 1};
}

void add_stamp(VtkhdfImage& image, std::int64_t step, double time_s) {
  image.add_attribute(image.root(), "step", one(step));
  image.add_attribute(image.root(), "time_s", one(time_s));
}

void add_geometry(VtkhdfImage& image, const FieldGroup& group, std::size_t n_points, std::size_t n_cells) {
  const std::array<std::int64_t, 2> version{1, 0};
  image.add_attribute(image.root(), "Version", std::span<const std::int64_t>(version));
  image.add_attribute(image.root(), "Type", std::string_view("UnstructuredGrid"));

  const std::size_t n_corners = points_per_cell(group.cell_type);
  std::vector<std::int64_t> offsets(n_cells + 1);
  for (std::size_t cell = 0; cell <= n_cells; ++cell) offsets[cell] = static_cast<std::int64_t>(cell * n_corners);
  const std::vector<std::uint8_t> types(n_cells, static_cast<std::uint8_t>(group.cell_type));

  const auto add_count = [&image](const char* name, std::size_t count) {
    image.add_dataset(image.root(), name, one(static_cast<std::int64_t>(count)));
  };
  add_count("NumberOfPoints", n_points);
  add_count("NumberOfCells", n_cells);
  add_count("NumberOfConnectivityIds", group.connectivity.size());
  const Hdf5Handle points = image.add_dataset(image.root(), "Points", std::span(group.points), 3);
  image.add_attribute(points.get(), "unit", std::string_view("m"));
  image.add_dataset(image.root(), "Connectivity", std::span(group.connectivity));
  image.add_dataset(image.root(), "Offsets", std::span<const std::int64_t>(offsets));
  image.add_dataset(image.root(), "Types", std::span(types));
}

void add_arrays(VtkhdfImage& image, hid_t parent, const std::vector<FieldArray>& arrays, std::size_t n_bodies) {
  for (const FieldArray& array : arrays) {
    const auto n_columns = static_cast<std::size_t>(array.n_components);
    const auto add_values = [&](const auto& values) {
      if (array.n_components < 1 || values.size() != n_bodies * n_columns) {
        throw std::logic_error(fmt::format("field '{}' has {} values for {} bodies with {} components", array.name,
                                           values.size(), n_bodies, array.n_components));
      }
      const Hdf5Handle dataset = image.add_dataset(parent, array.name.c_str(), std::span(values), n_columns);
      image.add_attribute(dataset.get(), "unit", array.unit);
    };
    std::visit(add_values, array.values);
  }
}

void check_geometry(const FieldGroup& group, std::size_t n_points) {
  if (group.points.size() % 3 != 0 || group.connectivity.size() % points_per_cell(group.cell_type) != 0) {
    throw std::logic_error(fmt::format("fields '{}': incomplete points or cells", group.name));
  }
  for (const std::int64_t point : group.connectivity) {
    if (point < 0 || static_cast<std::size_t>(point) >= n_points) {
      throw std::logic_error(fmt::format("fields '{}': a cell names point {} of {}", group.name, point, n_points));
    }
  }
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& final_path, const FieldGroup& group, std::int64_t step, double time_s) {
  const std::size_t n_points = group.points.size() / 3;
  const std::size_t n_cells = group.connectivity.size() / points_per_cell(group.cell_type);
  check_geometry(group, n_points);
  VtkhdfImage image(final_path);
  add_geometry(image, group, n_points, n_cells);
  add_stamp(image, step, time_s);
  add_arrays(image, image.point_data(), group.point_data, n_points);
  add_arrays(image, image.cell_data(), group.cell_data, n_cells);
  write_atomically(final_path, image.bytes());
}

FieldStamp read_field_stamp(const std::filesystem::path& path) {
  const Hdf5Checker check(path);
  const auto own = [&check](hid_t id, Hdf5Handle::Release release) { return check.own(id, release, read_action); };
  const Hdf5Handle access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // Published files never change, and some network file systems have no locks.
  check.expect(H5Pset_file_locking(access.get(), false, true), read_action);
  const Hdf5Handle file = own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  const Hdf5Handle root = own(H5Gopen2(file.get(), "VTKHDF", H5P_DEFAULT), H5Gclose);
  FieldStamp stamp;
  const Hdf5Handle step = own(H5Aopen(root.get(), "step", H5P_DEFAULT), H5Aclose);
  check.expect(H5Aread(step.get(), H5T_NATIVE_INT64, &stamp.step), read_action);
  const Hdf5Handle time = own(H5Aopen(root.get(), "time_s", H5P_DEFAULT), H5Aclose);
  check.expect(H5Aread(time.get(), H5T_NATIVE_DOUBLE, &stamp.time_s), read_action);
  return stamp;
}

}  // namespace ligament
