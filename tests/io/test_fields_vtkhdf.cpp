#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/fields_vtkhdf.hpp"
#include "io/hdf5_handle.hpp"
#include "scratch_folder.hpp"

namespace {

using ligament::CellType;
using ligament::FieldGroup;
using ligament::FileError;
using ligament::Hdf5Handle;
using ligament::read_field_stamp;
using ligament::read_file;
using ligament::vtkhdf_image;
using ligament::test::FullDisk;
using ligament::test::scratch_folder;

using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

FieldGroup two_elements() {
  FieldGroup group{"elements", CellType::quad, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}, {}, {}, {}};
  group.connectivity = {0, 1, 2, 3, 1, 4, 5, 2};
  group.point_data.push_back({"displacement", "m", 3, Numbers(18, 0.25)});
  group.cell_data.push_back({"stress", "Pa", 3, Numbers{1, 2, 3, 4, 5, 6}});
  group.cell_data.push_back({"material", "1", 1, Integers{7, 9'007'199'254'740'993}});
  return group;
}

void write_vtkhdf(const std::filesystem::path& path, const FieldGroup& group, std::int64_t step, double time_s) {
  ligament::write_atomically(path, vtkhdf_image(path, group, step, time_s));
}

FieldGroup no_contacts() {
  return {"contacts", CellType::line, {}, {}, {}, {{"slip", "m", 1, Numbers{}}, {"force", "N", 3, Numbers{}}}};
}

std::string text_attribute(hid_t file, const char* object, const char* name) {
  const Hdf5Handle attribute(H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  std::string text(H5Tget_size(type.get()), '\0');
  REQUIRE(H5Aread(attribute.get(), type.get(), text.data()) >= 0);
  return text;
}

template <class Value>
std::vector<Value> dataset(hid_t file, const char* name, hid_t memory_type) {
  const Hdf5Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(set.get()), H5Sclose);
  std::vector<Value> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  REQUIRE(H5Dread(set.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  return values;
}

TEST_CASE("a group is stored in the layout of VTKHDF UnstructuredGrid 1.0") {
  const auto path = scratch_folder("vtkhdf") / "elements_000120.hdf";
  write_vtkhdf(path, two_elements(), 120, 0.375);
  CHECK_FALSE(std::filesystem::exists(ligament::part_path(path)));
  CHECK(ligament::read_field_array(path, "Points").size() % 3 == 0);
  const auto stamp = read_field_stamp(path);
  CHECK(stamp.step == 120);
  CHECK(stamp.time_s == 0.375);

  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  REQUIRE(file.get() >= 0);
  CHECK(text_attribute(file.get(), "VTKHDF", "Type") == "UnstructuredGrid");
  CHECK(dataset<double>(file.get(), "VTKHDF/Points", H5T_NATIVE_DOUBLE) == two_elements().points);
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64) == Integers{6});
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/NumberOfCells", H5T_NATIVE_INT64) == Integers{2});
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/NumberOfConnectivityIds", H5T_NATIVE_INT64) == Integers{8});
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/Offsets", H5T_NATIVE_INT64) == Integers{0, 4, 8});
  CHECK(dataset<std::uint8_t>(file.get(), "VTKHDF/Types", H5T_NATIVE_UINT8) == std::vector<std::uint8_t>{9, 9});
  CHECK(dataset<double>(file.get(), "VTKHDF/CellData/stress", H5T_NATIVE_DOUBLE) == Numbers{1, 2, 3, 4, 5, 6});
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/CellData/material", H5T_NATIVE_INT64) ==
        Integers{7, 9'007'199'254'740'993});
  CHECK(text_attribute(file.get(), "VTKHDF/CellData/stress", "unit") == "Pa");
  CHECK(text_attribute(file.get(), "VTKHDF/PointData/displacement", "unit") == "m");
}

TEST_CASE("a group without cells is a valid file") {
  const auto path = scratch_folder("vtkhdf_empty") / "contacts_000000.hdf";
  write_vtkhdf(path, no_contacts(), 0, 0);
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  CHECK(dataset<std::int64_t>(file.get(), "VTKHDF/Offsets", H5T_NATIVE_INT64) == Integers{0});
  CHECK(dataset<double>(file.get(), "VTKHDF/CellData/force", H5T_NATIVE_DOUBLE).empty());
}

TEST_CASE("the same content gives the same bytes at another time and place") {
  const auto folder = scratch_folder("vtkhdf_bytes");
  write_vtkhdf(folder / "a.hdf", two_elements(), 1, 2);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_vtkhdf(folder / "another_name.hdf", two_elements(), 1, 2);
  CHECK(read_file(folder / "a.hdf") == read_file(folder / "another_name.hdf"));
}

TEST_CASE("a full disk or a missing folder is a FileError and leaves the former file") {
  const auto folder = scratch_folder("vtkhdf_full");
  write_vtkhdf(folder / "a.hdf", two_elements(), 1, 2);
  const std::string former = read_file(folder / "a.hdf");
  {
    const FullDisk full(2048);
    CHECK_THROWS_AS(write_vtkhdf(folder / "a.hdf", two_elements(), 2, 3), FileError);
  }
  CHECK(read_file(folder / "a.hdf") == former);
  CHECK_FALSE(std::filesystem::exists(folder / "a.hdf.part"));
  CHECK_THROWS_AS(write_vtkhdf(folder / "none" / "a.hdf", two_elements(), 1, 2), FileError);
  write_vtkhdf(folder / "a.hdf", two_elements(), 2, 3);
  CHECK(read_field_stamp(folder / "a.hdf").step == 2);
}

TEST_CASE("arrays that do not fit their bodies are mistakes of the program") {
  const auto path = scratch_folder("vtkhdf_mistakes") / "a.hdf";
  FieldGroup short_array = two_elements();
  short_array.cell_data[0].values = Numbers{1, 2, 3};
  CHECK_THROWS_AS(write_vtkhdf(path, short_array, 0, 0), std::logic_error);
  FieldGroup wild_cell = two_elements();
  wild_cell.connectivity[3] = 6;
  CHECK_THROWS_AS(write_vtkhdf(path, wild_cell, 0, 0), std::logic_error);
  FieldGroup open_cell = two_elements();
  open_cell.connectivity.pop_back();
  CHECK_THROWS_AS(write_vtkhdf(path, open_cell, 0, 0), std::logic_error);
  FieldGroup twice = two_elements();
  twice.cell_data.push_back(twice.cell_data[0]);
  CHECK_THROWS_AS(write_vtkhdf(path, twice, 0, 0), FileError);
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("files that are not fields are named with a reason") {
  const auto folder = scratch_folder("vtkhdf_read");
  CHECK_THROWS_WITH_AS((void)read_field_stamp(folder / "none.hdf"), doctest::Contains("No such file or directory"),
                       FileError);
  ligament::write_atomically(folder / "text.hdf", "not HDF5");
  CHECK_THROWS_WITH_AS((void)read_field_stamp(folder / "text.hdf"), doctest::Contains("text.hdf"), FileError);
}

}  // namespace
