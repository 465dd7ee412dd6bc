#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/field_series.hpp"
#include "scratch_folder.hpp"

namespace {

using ligament::CellType;
using ligament::FieldSeries;
using ligament::FileError;
using ligament::read_file;
using ligament::test::scratch_folder;

void add(FieldSeries& series, std::int64_t step) {
  const double time_s = 0.1 * static_cast<double>(step);
  const ligament::FieldGroup group{"particles", CellType::vertex, {0, 0, 0}, {0}, {}, {}};
  series.add(step, time_s, ligament::vtkhdf_image(series.file_of(step), group, step, time_s));
}

void output(FieldSeries& series, std::int64_t step) {
  add(series, step);
  series.flush();
}

TEST_CASE("the list is what ParaView reads") {
  const auto folder = scratch_folder("series");
  FieldSeries series(folder, "particles");
  output(series, 0);
  output(series, 120);
  output(series, 12'345'678);
  const auto list = nlohmann::json::parse(read_file(folder / "particles.hdf.series"));
  CHECK(list["file-series-version"] == "1.0");
  REQUIRE(list["files"].size() == 3);
  CHECK(list["files"][1]["name"] == "particles_000120.hdf");
  CHECK(list["files"][1]["time"] == 12.0);
  CHECK(list["files"][1]["step"] == 120);
  CHECK(list["files"][2]["name"] == "particles_12345678.hdf");
  CHECK_THROWS_AS(series.add(120, 12.0, ""), std::logic_error);
}

TEST_CASE("a resumed series has the bytes of an undisturbed one and no later files") {
  const auto folder_a = scratch_folder("series_undisturbed");
  const auto folder_b = scratch_folder("series_resumed");
  FieldSeries undisturbed(folder_a, "particles");
  for (const int step : {0, 1, 3, 7, 9}) output(undisturbed, step);
  {
    FieldSeries killed(folder_b, "particles");
    for (const int step : {0, 1, 3, 5}) output(killed, step);
  }
  const std::vector<std::string> foreign{"particles_7.hdf", "elements_000007.hdf", "particles_big_000007.hdf"};
  for (const std::string& name : foreign) ligament::write_atomically(folder_b / name, "foreign");
  ligament::write_atomically(folder_b / "particles_000003.hdf.part", "torn");
  ligament::write_atomically(folder_b / "particles.hdf.series", "lost");

  FieldSeries resumed(folder_b, "particles");
  resumed.resume(3);
  CHECK_FALSE(std::filesystem::exists(folder_b / "particles_000005.hdf"));
  CHECK_FALSE(std::filesystem::exists(folder_b / "particles_000003.hdf.part"));
  for (const std::string& name : foreign) CHECK(std::filesystem::exists(folder_b / name));
  for (const int step : {7, 9}) output(resumed, step);
  CHECK(read_file(folder_a / "particles.hdf.series") == read_file(folder_b / "particles.hdf.series"));
}

TEST_CASE("fields that find no room wait for it, and the list names what is there") {
  const auto folder = scratch_folder("series_full");
  FieldSeries undisturbed(scratch_folder("series_room"), "particles");
  FieldSeries series(folder, "particles");
  for (const int step : {0, 3, 7}) output(undisturbed, step);
  output(series, 0);
  const std::string list = read_file(folder / "particles.hdf.series");
  {
    const ligament::test::FullDisk full(2048);
    for (const int step : {3, 7}) {
      add(series, step);
      CHECK_THROWS_AS(series.flush(), FileError);
      CHECK_FALSE(std::filesystem::exists(series.file_of(step)));
    }
    CHECK(read_file(folder / "particles.hdf.series") == list);
  }
  CHECK(series.n_waiting() == 2 * read_file(series.file_of(0)).size());
  series.flush();
  CHECK(series.n_waiting() == 0);
  for (const int step : {0, 3, 7}) CHECK(read_file(series.file_of(step)) == read_file(undisturbed.file_of(step)));
  CHECK(read_file(folder / "particles.hdf.series") ==
        read_file(undisturbed.file_of(0).parent_path() / "particles.hdf.series"));
}

TEST_CASE("a series starts anew after step -1 and refuses damaged files and missing folders") {
  const auto folder = scratch_folder("series_anew");
  FieldSeries series(folder, "particles");
  output(series, 4);
  series.resume(-1);
  CHECK_FALSE(std::filesystem::exists(series.file_of(4)));
  output(series, 0);
  ligament::write_atomically(series.file_of(2), "damaged");
  CHECK_THROWS_AS(series.resume(2), FileError);
  CHECK_THROWS_AS(FieldSeries(folder / "none", "particles").resume(0), FileError);
}

}  // namespace
