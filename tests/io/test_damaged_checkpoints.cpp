#include <doctest/doctest.h>
#include <fmt/format.h>

#include <random>
#include <string>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint_store.hpp"
#include "scratch_folder.hpp"

/// Checkpoints of the size of real ones, damaged in many ways: none passes for a good one.
namespace ligament {
namespace {

constexpr std::size_t block = 4096;  // what disks and file systems lose at a time

std::string payload_of(std::mt19937& random) {
  std::string payload(60 * block + 17, '\0');
  for (char& byte : payload) byte = static_cast<char>(random() >> 24);
  return payload;
}

/// The content of a checkpoint file.
std::string written(const std::filesystem::path& path, std::mt19937& random) {
  CheckpointHeader header;
  header.run_id = "a1";
  header.case_text = "title = \"a case\"\n";
  write_checkpoint(path, header, payload_of(random));
  return read_file(path);
}

/// Why this content is no good checkpoint; empty if it is taken for one.
std::string refusal(const std::string& content) {
  try {
    parse_checkpoint("damaged.ckpt", content);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST_CASE("a checkpoint cut at any block, or with a block of zeros, is refused") {
  std::mt19937 random(1);
  const std::string content = written(test::scratch_folder("damaged_blocks") / "a.ckpt", random);
  REQUIRE(refusal(content).empty());
  for (std::size_t begin = 0; begin < content.size(); begin += block) {
    CAPTURE(begin);
    CHECK(refusal(content.substr(0, begin)).find("damaged.ckpt' is truncated") != std::string::npos);
    std::string holed = content;
    holed.replace(begin, std::min(block, content.size() - begin), std::min(block, content.size() - begin), '\0');
    CHECK(refusal(holed).starts_with("checkpoint file 'damaged.ckpt' is"));
  }
}

TEST_CASE("of 10 000 checkpoints with one bit flipped, each is refused by name") {
  std::mt19937 random(2);
  std::string content = written(test::scratch_folder("damaged_bits") / "a.ckpt", random);
  const auto flip = [&content](std::size_t bit) {
    content[bit / 8] = static_cast<char>(content[bit / 8] ^ (1 << bit % 8));
  };
  std::size_t n_refused = 0;
  for (int variant = 0; variant < 10'000; ++variant) {
    const std::size_t bit = std::uniform_int_distribution<std::size_t>(0, 8 * content.size() - 1)(random);
    flip(bit);
    if (refusal(content).starts_with("checkpoint file 'damaged.ckpt' ")) ++n_refused;
    flip(bit);
  }
  CHECK(n_refused == 10'000);
  CHECK(refusal(content).empty());
}

TEST_CASE("whatever is damaged in the newest checkpoint, the one before is taken and the newest is named") {
  std::mt19937 random(3);
  const auto folder = test::scratch_folder("damaged_newest");
  CheckpointStore store(folder, "a1", 3);
  CheckpointHeader header;
  header.step = 10;
  const std::string good = payload_of(random);
  store.write(header, good);
  header.step = 20;
  const auto newest = store.write(header, payload_of(random));
  const std::string content = read_file(newest);
  for (int variant = 0; variant < 50; ++variant) {
    std::string damaged = content;
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, content.size() - 1)(random);
    if (variant % 2 == 0) {
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << variant % 8));
    } else {
      damaged.resize(at);
    }
    write_atomically(newest, damaged);
    std::filesystem::path named;
    const auto checkpoint = store.newest_good([&named](const auto& path, const std::string&) { named = path; });
    REQUIRE(checkpoint);
    CHECK(checkpoint->header.step == 10);
    CHECK(checkpoint->payload == good);
    CHECK(named == newest);
  }
}

}  // namespace
}  // namespace ligament
