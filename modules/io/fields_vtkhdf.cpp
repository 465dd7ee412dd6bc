#include "io/fields_vtkhdf.hpp"

#include <fmt/core.h>

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

#include "io/hdf5_image.hpp"

namespace ligament {
namespace {

constexpr auto read_action = "read";

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

/// The groups of a VTKHDF file.
class VtkhdfImage : public Hdf5Image {
 public:
  explicit VtkhdfImage(const std::filesystem::path& path)
      : Hdf5Image(path),
        root_(create_group(file(), "VTKHDF")),
        point_data_(create_group(root_.get(), "PointData")),
        cell_data_(create_group(root_.get(), "CellData")) {}

  [[nodiscard]] hid_t root() const { return root_.get(); }
  [[nodiscard]] hid_t point_data() const { return point_data_.get(); }
  [[nodiscard]] hid_t cell_data() const { return cell_data_.get(); }

 private:
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

Hdf5Handle open_to_read(const Hdf5Checker& check, const std::filesystem::path& path) {
  const Hdf5Handle access = check.own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, read_action);
  // Published files never change, and some network file systems have no locks.
  check.expect(H5Pset_file_locking(access.get(), false, true), read_action);
  return check.own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, read_action);
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

std::string vtkhdf_image(const std::filesystem::path& path, const FieldGroup& group, std::int64_t step, double time_s) {
  const std::size_t n_points = group.points.size() / 3;
  const std::size_t n_cells = group.connectivity.size() / points_per_cell(group.cell_type);
  check_geometry(group, n_points);
  VtkhdfImage image(path);
  add_geometry(image, group, n_points, n_cells);
  add_stamp(image, step, time_s);
  add_arrays(image, image.point_data(), group.point_data, n_points);
  add_arrays(image, image.cell_data(), group.cell_data, n_cells);
  return image.bytes();
}

std::vector<double> read_field_array(const std::filesystem::path& path, const std::string& name) {
  const Hdf5Checker check(path);
  const auto own = [&check](hid_t id, Hdf5Handle::Release release) { return check.own(id, release, read_action); };
  const Hdf5Handle file = open_to_read(check, path);
  const Hdf5Handle dataset = own(H5Dopen2(file.get(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space = own(H5Dget_space(dataset.get()), H5Sclose);
  const hssize_t n_values = H5Sget_simple_extent_npoints(space.get());
  check.expect(n_values, read_action);
  std::vector<double> values(static_cast<std::size_t>(n_values));
  check.expect(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), read_action);
  return values;
}

FieldStamp read_field_stamp(const std::filesystem::path& path) {
  const Hdf5Checker check(path);
  const auto own = [&check](hid_t id, Hdf5Handle::Release release) { return check.own(id, release, read_action); };
  const Hdf5Handle file = open_to_read(check, path);
  const Hdf5Handle root = own(H5Gopen2(file.get(), "VTKHDF", H5P_DEFAULT), H5Gclose);
  FieldStamp stamp;
  const Hdf5Handle step = own(H5Aopen(root.get(), "step", H5P_DEFAULT), H5Aclose);
  check.expect(H5Aread(step.get(), H5T_NATIVE_INT64, &stamp.step), read_action);
  const Hdf5Handle time = own(H5Aopen(root.get(), "time_s", H5P_DEFAULT), H5Aclose);
  check.expect(H5Aread(time.get(), H5T_NATIVE_DOUBLE, &stamp.time_s), read_action);
  return stamp;
}

}  // namespace ligament
