#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "scratch_folder.hpp"

namespace {

using ligament::CsvCell;
using ligament::CsvTable;
using ligament::FileError;
using ligament::InputError;
using ligament::read_csv;
using ligament::read_file;
using ligament::write_atomically;
using ligament::test::FullDisk;
using ligament::test::scratch_folder;

const std::vector<std::string> columns{"time_s", "n_broken"};

void append(CsvTable& table, std::int64_t step, double time_s, double n_broken) {
  table.append(step, std::array{time_s, n_broken});
}

TEST_CASE("numbers are written short and read back to the same bits") {
  const auto path = scratch_folder("csv_numbers") / "history.csv";
  CsvTable table = CsvTable::create(path, columns);
  append(table, 0, 0.1, 0);
  append(table, 50, 1.0 / 3.0, 1200);
  append(table, 100, std::nan(""), -1e-300);
  table.sync();
  CHECK(read_file(path) == "step,time_s,n_broken\n0,0.1,0\n50,0.3333333333333333,1200\n100,nan,-1e-300\n");

  const auto content = read_csv(path);
  CHECK(content.columns == std::vector<std::string>{"step", "time_s", "n_broken"});
  REQUIRE(content.rows.size() == 3);
  CHECK(content.rows[1][2] == "1200");
  const std::vector<double> times = content.numbers("time_s");
  CHECK(times[0] == 0.1);
  CHECK(times[1] == 1.0 / 3.0);
  CHECK(std::isnan(times[2]));
  CHECK(content.numbers("step") == std::vector<double>{0, 50, 100});
  CHECK_THROWS_AS((void)content.numbers("time"), InputError);
}

TEST_CASE("rows may hold words and several rows one step") {
  const auto path = scratch_folder("csv_words") / "cracks.csv";
  const std::vector<std::string> crack_columns{"contact", "mode", "energy_J"};
  CsvTable table = CsvTable::create(path, crack_columns);
  table.append(7, std::array<CsvCell, 3>{std::int64_t{12}, "tension", 0.5});
  table.append(7, std::array<CsvCell, 3>{std::int64_t{13}, "shear", 1e-9});
  table.flush();
  CHECK(read_file(path) == "step,contact,mode,energy_J\n7,12,tension,0.5\n7,13,shear,1e-09\n");
  CHECK_THROWS_AS((void)read_csv(path).numbers("mode"), FileError);
  CHECK_THROWS_AS(table.append(8, std::array<CsvCell, 3>{std::int64_t{14}, "a,b", 1.0}), InputError);
  CHECK_THROWS_AS(table.append(8, std::array{1.0}), std::logic_error);
  CHECK(read_csv(path).rows.size() == 2);
}

TEST_CASE("a resumed table has the bytes of an undisturbed one") {
  const auto folder = scratch_folder("csv_resume");
  const auto write_rows = [](CsvTable& table, int first, int last) {
    for (int row = first; row <= last; ++row) append(table, 10 * row, 0.1 * row, row / 3);
    table.flush();
  };
  CsvTable undisturbed = CsvTable::create(folder / "a.csv", columns);
  write_rows(undisturbed, 0, 12);
  {
    CsvTable killed = CsvTable::create(folder / "b.csv", columns);
    write_rows(killed, 0, 9);
  }
  CsvTable resumed = CsvTable::resume(folder / "b.csv", columns, 65);
  CHECK(read_csv(folder / "b.csv").rows.size() == 7);
  write_rows(resumed, 7, 12);
  CHECK(read_file(folder / "a.csv") == read_file(folder / "b.csv"));
}

TEST_CASE("resume drops a torn row and whatever follows a later step") {
  const auto path = scratch_folder("csv_torn") / "a.csv";
  write_atomically(path, "step,time_s,n_broken\n0,0,0\n10,1,0\n20,2");
  CHECK(read_csv(path).rows.size() == 2);
  CsvTable table = CsvTable::resume(path, columns, 20);
  CHECK(read_file(path) == "step,time_s,n_broken\n0,0,0\n10,1,0\n");
  append(table, 20, 2, 1);
  table.flush();
  CHECK(read_file(path) == "step,time_s,n_broken\n0,0,0\n10,1,0\n20,2,1\n");

  write_atomically(path, "step,time_s,n_broken\n0,0,0\n10,1,0\ndamaged by a power failure");
  (void)CsvTable::resume(path, columns, 0);
  CHECK(read_file(path) == "step,time_s,n_broken\n0,0,0\n");
}

TEST_CASE("resume refuses a file that is not its own and leaves it alone") {
  const auto path = scratch_folder("csv_refuse") / "a.csv";
  CHECK_THROWS_AS((void)CsvTable::resume(path, columns, 10), FileError);
  const std::array contents{"",
                            "step,time_s\n0,0\n20,0\n",
                            "step,time_s,n_broken",
                            "step,time_s,n_broken\n10,0,0\n0,0,0\n",
                            "step,time_s,n_broken\n0,0\n20,0,0\n",
                            "step,time_s,n_broken\nx,0,0\n20,0,0\n"};
  for (const std::string content : contents) {
    CAPTURE(content);
    write_atomically(path, content);
    CHECK_THROWS_AS((void)CsvTable::resume(path, columns, 10), FileError);
    CHECK(read_file(path) == content);
  }
}

TEST_CASE("rows that find no room wait for it, in their order") {
  const auto path = scratch_folder("csv_full") / "a.csv";
  CsvTable table = CsvTable::create(path, columns);
  append(table, 0, 0, 0);
  table.flush();
  const std::string before = read_file(path);
  {
    const FullDisk full(before.size() + 3);
    for (const int step : {10, 20}) {
      append(table, step, 0.125, 77);
      CHECK_THROWS_AS(table.flush(), FileError);
      CHECK_THROWS_AS(table.sync(), FileError);
      CHECK(read_file(path) == before);
    }
    CHECK(table.n_waiting() == std::string("10,0.125,77\n20,0.125,77\n").size());
  }
  table.flush();
  CHECK(table.n_waiting() == 0);
  append(table, 30, 0.125, 77);
  table.flush();
  CHECK(read_file(path) == before + "10,0.125,77\n20,0.125,77\n30,0.125,77\n");
}

TEST_CASE("a table that is removed or replaced under the run is not written to") {
  const auto path = scratch_folder("csv_removed") / "a.csv";
  CsvTable table = CsvTable::create(path, columns);
  append(table, 0, 0, 0);
  std::filesystem::remove(path);
  CHECK_THROWS_AS(table.flush(), FileError);
  write_atomically(path, "another");
  CHECK_THROWS_AS(table.sync(), FileError);
  CHECK(read_file(path) == "another");
}

TEST_CASE("tables that cannot be written or read say so") {
  const auto folder = scratch_folder("csv_errors");
  CHECK_THROWS_AS((void)CsvTable::create(folder / "none" / "a.csv", columns), FileError);
  CHECK_THROWS_AS((void)CsvTable::create(folder / "a.csv", std::vector<std::string>{"a,b"}), InputError);
  CHECK_FALSE(std::filesystem::exists(folder / "a.csv"));
  CHECK_THROWS_AS((void)read_csv(folder / "a.csv"), FileError);
  write_atomically(folder / "a.csv", "step,x\n0,1\n1,2,3\n");
  CHECK_THROWS_WITH_AS((void)read_csv(folder / "a.csv"),
                       ((folder / "a.csv").string() + ":3: 3 cells under a header of 2").c_str(), FileError);
  write_atomically(folder / "a.csv", "step,x");
  CHECK_THROWS_AS((void)read_csv(folder / "a.csv"), FileError);
}

}  // namespace
