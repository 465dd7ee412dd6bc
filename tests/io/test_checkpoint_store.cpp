#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/checkpoint_store.hpp"
#include "scratch_folder.hpp"

namespace fs = std::filesystem;
using ligament::CheckpointHeader;
using ligament::CheckpointStore;
using ligament::test::FullDisk;
using ligament::test::scratch_folder;

namespace {

CheckpointHeader at_step(std::int64_t step) {
  CheckpointHeader header;
  header.step = step;
  return header;
}

std::string payload_at(std::int64_t step) { return "state at step " + std::to_string(step); }

fs::path write(CheckpointStore& store, std::int64_t step) { return store.write(at_step(step), payload_at(step)); }

std::vector<std::string> names(const CheckpointStore& store) {
  std::vector<std::string> result;
  for (const auto& path : store.list()) {
    result.push_back(path.filename().string());
  }
  return result;
}

void put(const fs::path& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

void damage(const fs::path& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-20, std::ios::end);
  file.put('!');
}

struct Found {
  std::string payload;
  std::vector<std::string> reasons;
};

Found newest_good(const CheckpointStore& store) {
  Found found;
  const auto checkpoint =
      store.newest_good([&](const fs::path&, const std::string& reason) { found.reasons.push_back(reason); });
  found.payload = checkpoint ? checkpoint->payload : "";
  return found;
}

}  // namespace

TEST_CASE("a store keeps the newest checkpoints of its run") {
  const fs::path folder = scratch_folder("keep");
  CheckpointStore store(folder, "run_a", 2);
  CHECK(write(store, 0) == folder / "step_000000000000.ckpt");
  write(store, 1000);
  CHECK(names(store) == std::vector<std::string>{"step_000000001000.ckpt", "step_000000000000.ckpt"});
  write(store, 2000);
  write(store, 10'000'000'000'000);
  CHECK(names(store) == std::vector<std::string>{"step_10000000000000.ckpt", "step_000000002000.ckpt"});
  CHECK(newest_good(store).payload == payload_at(10'000'000'000'000));
}

TEST_CASE("a checkpoint carries the id of its store's run") {
  CheckpointStore store(scratch_folder("run_id"), "run_a", 1);
  CHECK(ligament::read_checkpoint_header(write(store, 5)).run_id == "run_a");
}

TEST_CASE("a store makes its folder, and is empty before") {
  const fs::path folder = scratch_folder("made") / "deep" / "folder";
  CheckpointStore store(folder, "run_a", 1);
  CHECK(store.list().empty());
  CHECK(newest_good(store).payload.empty());
  write(store, 1);
  CHECK(store.list().size() == 1);
}

TEST_CASE("a store refuses to keep nothing") {
  CHECK_THROWS_AS(CheckpointStore("somewhere", "run_a", 0), ligament::InputError);
}

TEST_CASE("a damaged checkpoint is passed over with its reason") {
  CheckpointStore store(scratch_folder("damaged"), "run_a", 3);
  write(store, 1);
  const fs::path newest = write(store, 2);
  damage(newest);
  const Found found = newest_good(store);
  CHECK(found.payload == payload_at(1));
  REQUIRE(found.reasons.size() == 1);
  CHECK(found.reasons[0].find(newest.string()) != std::string::npos);
  CHECK(found.reasons[0].find("is damaged") != std::string::npos);
}

TEST_CASE("a damaged checkpoint does not count among those kept") {
  CheckpointStore store(scratch_folder("damaged_kept"), "run_a", 2);
  write(store, 1);
  damage(write(store, 2));
  write(store, 3);
  CHECK(store.list().size() == 3);
  damage(store.list().front());
  CHECK(newest_good(store).payload == payload_at(1));
}

TEST_CASE("checkpoints of another run are neither taken nor removed") {
  const fs::path folder = scratch_folder("other_run");
  CheckpointStore other(folder, "run_b", 1);
  write(other, 9);
  CheckpointStore store(folder, "run_a", 1);
  write(store, 1);
  write(store, 10);
  write(store, 11);
  CHECK(names(store) == std::vector<std::string>{"step_000000000011.ckpt", "step_000000000009.ckpt"});
  fs::remove(folder / "step_000000000011.ckpt");
  const Found found = newest_good(store);
  CHECK(found.payload.empty());
  REQUIRE(found.reasons.size() == 1);
  CHECK(found.reasons[0].find("belongs to another run, run_b") != std::string::npos);
}

TEST_CASE("a checkpoint ahead of the one just written stays") {
  CheckpointStore store(scratch_folder("ahead"), "run_a", 1);
  write(store, 20);
  write(store, 10);
  CHECK(names(store) == std::vector<std::string>{"step_000000000020.ckpt", "step_000000000010.ckpt"});
}

TEST_CASE("interrupted writes are never listed and removed by the next write") {
  const fs::path folder = scratch_folder("part");
  CheckpointStore store(folder, "run_a", 2);
  put(folder / "step_000000000007.ckpt.part", "half of it");
  put(folder / "notes.txt", "mine");
  CHECK(store.list().empty());
  CHECK(newest_good(store).reasons.empty());
  write(store, 8);
  CHECK_FALSE(fs::exists(folder / "step_000000000007.ckpt.part"));
  CHECK(fs::exists(folder / "notes.txt"));
}

TEST_CASE("only names of checkpoints are listed") {
  const fs::path folder = scratch_folder("names");
  for (const char* name :
       {"step_1.ckpt", "step_000000000001.txt", "step_00000000001x.ckpt", "step_.ckpt", "s", "old"}) {
    put(folder / name, "");
  }
  CHECK(CheckpointStore(folder, "run_a", 1).list().empty());
}

TEST_CASE("a folder that can't be made is a FileError") {
  const fs::path file = scratch_folder("no_folder") / "file";
  put(file, "");
  CheckpointStore store(file / "checkpoints", "run_a", 1);
  CHECK_THROWS_AS(write(store, 1), ligament::FileError);
}

TEST_CASE("a file that can't be opened for writing leaves the old checkpoints") {
  const fs::path folder = scratch_folder("not_opened");
  CheckpointStore store(folder, "run_a", 1);
  write(store, 1);
  // A folder in the way stops every user, root too, which permissions do not.
  fs::create_directories(folder / "step_000000000002.ckpt.part" / "full");
  CHECK_THROWS_AS(write(store, 2), ligament::FileError);
  CHECK(names(store) == std::vector<std::string>{"step_000000000001.ckpt"});
  CHECK(newest_good(store).payload == payload_at(1));
}

TEST_CASE("a disk that fills up leaves the old checkpoints") {
  CheckpointStore store(scratch_folder("disk_full"), "run_a", 1);
  write(store, 1);
  {
    const FullDisk limit(4096);
    CHECK_THROWS_AS(store.write(at_step(2), std::string(65536, 'x')), ligament::FileError);
    CHECK_THROWS_AS(store.write(at_step(1), std::string(65536, 'x')), ligament::FileError);
  }
  CHECK(names(store) == std::vector<std::string>{"step_000000000001.ckpt"});
  CHECK(newest_good(store).payload == payload_at(1));
}
