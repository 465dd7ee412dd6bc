#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "scratch_folder.hpp"

namespace {

using ligament::FileError;
using ligament::part_path;
using ligament::read_file;
using ligament::write_atomically;
using ligament::test::FullDisk;
using ligament::test::scratch_folder;

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no FileError";
}

TEST_CASE("write_atomically writes and replaces any bytes and leaves no part behind") {
  const auto path = scratch_folder("atomic") / "a.bin";
  const std::string binary("one\0two\n", 8);
  write_atomically(path, binary);
  CHECK(read_file(path) == binary);
  const std::string longer_than_a_buffer(200'000, 'x');
  write_atomically(path, longer_than_a_buffer);
  CHECK(read_file(path) == longer_than_a_buffer);
  write_atomically(path, "");
  CHECK(read_file(path).empty());
  CHECK_FALSE(std::filesystem::exists(part_path(path)));
}

TEST_CASE("a full disk leaves the former file and no part") {
  const auto path = scratch_folder("atomic_full") / "a.txt";
  write_atomically(path, "former");
  std::string message;
  {
    const FullDisk full(1000);
    message = message_of([&] { write_atomically(path, std::string(5000, 'x')); });
  }
  CHECK(message == "cannot write " + part_path(path).string() + ": File too large");
  CHECK(read_file(path) == "former");
  CHECK_FALSE(std::filesystem::exists(part_path(path)));
}

TEST_CASE("a folder that is missing or a name that is taken by a folder is named with the reason") {
  const auto folder = scratch_folder("atomic_refused");
  const auto missing = folder / "none" / "a.txt";
  CHECK(message_of([&] { write_atomically(missing, "x"); }) ==
        "cannot create " + part_path(missing).string() + ": No such file or directory");

  const auto taken = folder / "taken";
  std::filesystem::create_directory(taken);
  CHECK(message_of([&] { write_atomically(taken, "x"); }) == "cannot write " + taken.string() + ": Is a directory");
  CHECK_FALSE(std::filesystem::exists(part_path(taken)));
}

TEST_CASE("publish gives a part its name, or removes it") {
  const auto folder = scratch_folder("atomic_publish");
  const auto part = folder / "a.part";
  std::ofstream(part) << "written by another library";
  ligament::publish(part, folder / "a");
  CHECK(read_file(folder / "a") == "written by another library");
  CHECK_FALSE(std::filesystem::exists(part));

  std::ofstream(part) << "x";
  CHECK_THROWS_AS(ligament::publish(part, folder / "none" / "a"), FileError);
  CHECK_FALSE(std::filesystem::exists(part));
  CHECK_THROWS_AS(ligament::publish(part, folder / "a"), FileError);
}

TEST_CASE("read_file names what it cannot read") {
  const auto folder = scratch_folder("atomic_read");
  const std::string missing = (folder / "none").string();
  CHECK(message_of([&] { (void)read_file(missing); }) == "cannot open " + missing + ": No such file or directory");
  CHECK(message_of([&] { (void)read_file(folder); }) == "cannot read " + folder.string() + ": Is a directory");
}

}  // namespace
