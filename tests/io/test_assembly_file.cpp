#include <doctest/doctest.h>

#include <vector>

#include "core/error.hpp"
#include "io/assembly_file.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_image.hpp"
#include "scratch_folder.hpp"

using namespace ligament;
using ligament::test::FullDisk;
using ligament::test::scratch_folder;

namespace {

Packing three_discs(double shift = 0.0) {
  return {{{1.0 / 3.0 + shift, 0.1}, {2.0e-17, -0.25}, {1e300, 5e-324}}, {0.1, 1.0 / 7.0, 3e-5}, {{"area_ratio", 0.5}}};
}

Assemblies assemblies_of(const std::vector<std::string>& zones) {
  Assemblies assemblies{"0.0.1", "title = \"Säule\"\n", std::string(100000, '#'), 7, {}};
  double shift = 0.0;
  for (const std::string& zone : zones) {
    assemblies.zones.push_back({zone, "random", {{0.0, 0.0}, {1.0, 2.0}}, three_discs(shift)});
    shift += 1.0;
  }
  return assemblies;
}

void check_same_discs(const Packing& read, const Packing& written) {
  CHECK(read.position == written.position);
  CHECK(read.radius == written.radius);
}

Packing discs_in(const std::string& content, const std::string& zone = "middle") {
  return read_discs(content, "discs", zone);
}

/// What is said of a file with a group 'middle' that holds these datasets.
struct Dataset {
  const char* name;
  std::vector<double> values;
  std::size_t n_columns;
  std::string unit = "m";
};
std::string message_for(const std::vector<Dataset>& datasets) {
  const Hdf5Image image("discs");
  const Hdf5Handle group = image.create_group(image.file(), "middle");
  for (const Dataset& dataset : datasets) {
    const Hdf5Handle written =
        image.add_dataset(group.get(), dataset.name, std::span<const double>(dataset.values), dataset.n_columns);
    image.add_attribute(written.get(), "unit", std::string_view(dataset.unit));
  }
  try {
    static_cast<void>(discs_in(image.bytes()));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

std::string message_for_csv(const std::string& content) {
  try {
    static_cast<void>(discs_in(content));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

}  // namespace

TEST_CASE("discs come back from HDF5 as the same bits, those of each zone") {
  const auto path = scratch_folder("assembly_hdf5") / "discs.h5";
  write_assemblies_hdf5(path, assemblies_of({"left", "right"}));
  CHECK_FALSE(std::filesystem::exists(part_path(path)));
  const std::string content = read_file(path);
  check_same_discs(read_discs(content, path, "left"), three_discs());
  check_same_discs(read_discs(content, path, "right"), three_discs(1.0));
  CHECK_THROWS_WITH_AS(static_cast<void>(read_discs(content, "discs.h5", "middle")),
                       "discs.h5: has no group 'middle' (there are: 'left', 'right')", InputError);
}

TEST_CASE("the only zone of a file is taken whatever its name") {
  const auto path = scratch_folder("assembly_only") / "discs.h5";
  write_assemblies_hdf5(path, assemblies_of({"left"}));
  check_same_discs(read_discs(read_file(path), path, "middle"), three_discs());
}

TEST_CASE("the bytes of a file depend on what is in it alone") {
  const auto folder = scratch_folder("assembly_bytes");
  write_assemblies_hdf5(folder / "a.h5", assemblies_of({"left"}));
  write_assemblies_hdf5(folder / "b.h5", assemblies_of({"left"}));
  CHECK(read_file(folder / "a.h5") == read_file(folder / "b.h5"));
}

TEST_CASE("discs come back from CSV as the same bits") {
  const auto path = scratch_folder("assembly_csv") / "discs.csv";
  write_discs_csv(path, three_discs());
  const std::string content = read_file(path);
  CHECK(content.starts_with("x_m,y_m,radius_m\n0.3333333333333333,0.1,0.1\n"));
  check_same_discs(read_discs(content, path, "middle"), three_discs());
}

TEST_CASE("a CSV from elsewhere may end its lines with two characters and its last one with none") {
  const Packing packing = discs_in("x_m,y_m,radius_m\r\n1,2,0.5\r\n3,4e-1,0.25");
  check_same_discs(packing, {{{1.0, 2.0}, {3.0, 0.4}}, {0.5, 0.25}, {}});
  CHECK(discs_in("x_m,y_m,radius_m\n").size() == 0);
}

TEST_CASE("what is no table of discs is refused with its row") {
  const std::string header =
      "discs: is neither HDF5 nor a CSV file with the header 'x_m,y_m,radius_m' (it begins with ";
  CHECK(message_for_csv("") == header + "'')");
  CHECK(message_for_csv("x_m,y_m\n1,2\n") == header + "'x_m,y_m')");
  CHECK(message_for_csv("x_mm,y_mm,radius_mm\n1,2,3\n") == header + "'x_mm,y_mm,radius_mm')");
  const auto row_two = [](const std::string& row) {
    return message_for_csv("x_m,y_m,radius_m\n1,2,0.5\n" + row + "\n1,2,0.5\n");
  };
  for (const char* row : {"1,2", "1,2,3,4", "1,2,three", "1,,3", "", "1, 2, 3", "0x1,2,3"}) {
    CHECK(row_two(row) == "discs: row 2 is '" + std::string(row) + "', not three numbers between commas");
  }
}

TEST_CASE("HDF5 files without discs are refused") {
  CHECK(message_for({{"position", {1, 2, 3, 4}, 2}, {"radius", {1, 2}, 1}}) == "nothing is wrong");
  CHECK(message_for({{"radius", {1, 2}, 1}}) == "discs: has no dataset 'position'");
  CHECK(message_for({{"position", {1, 2, 3, 4}, 2}}) == "discs: has no dataset 'radius'");
  CHECK(message_for({{"position", {1, 2, 3}, 3}, {"radius", {1}, 1}}) ==
        "discs: the dataset 'position' is not a table of floating-point numbers with 2 columns");
  CHECK(message_for({{"position", {1, 2}, 2}, {"radius", {1, 2}, 2}}) ==
        "discs: the dataset 'radius' is not a table of floating-point numbers with 1 column");
  CHECK(message_for({{"position", {1, 2}, 2}, {"radius", {1, 2}, 1}}) ==
        "discs: 'position' has 1 rows and 'radius' has 2");
  CHECK(message_for({{"position", {1, 2}, 2, "mm"}, {"radius", {1}, 1}}) ==
        "discs: the dataset 'position' is in 'mm', but must be in 'm'");
  CHECK_THROWS_WITH_AS(static_cast<void>(discs_in(Hdf5Image("discs").bytes())),
                       "discs: has no group 'middle' (there are: none)", InputError);
}

TEST_CASE("a file that is cut off is refused, wherever it ends") {
  const auto path = scratch_folder("assembly_cut") / "discs.h5";
  write_assemblies_hdf5(path, assemblies_of({"left"}));
  const std::string content = read_file(path);
  for (const std::size_t length : {8, 50, 512, 1000, 20000}) {
    CAPTURE(length);
    REQUIRE(length < content.size());
    CHECK_THROWS_AS(static_cast<void>(read_discs(content.substr(0, length), path, "left")), InputError);
  }
}

TEST_CASE("a disk that is full leaves no file behind") {
  const auto folder = scratch_folder("assembly_full_disk");
  const FullDisk disk(10);
  CHECK_THROWS_AS(write_assemblies_hdf5(folder / "discs.h5", assemblies_of({"left"})), FileError);
  CHECK_THROWS_AS(write_discs_csv(folder / "discs.csv", three_discs()), FileError);
  CHECK(std::filesystem::is_empty(folder));
}
