#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "io/checkpoint_file.hpp"
#include "scratch_folder.hpp"

namespace fs = std::filesystem;
using ligament::CheckpointHeader;
using ligament::test::scratch_folder;

namespace {

constexpr std::size_t version_offset = 20;
constexpr std::size_t header_length_offset = version_offset + sizeof(std::uint32_t);

CheckpointHeader example_header() {
  CheckpointHeader header;
  header.program_version = "0.1.0";
  header.build = "Release";
  header.compiler = "GNU 12.2.0";
  header.run_id = "a1b2c3";
  header.case_hash = "00ff";
  header.case_text = "title = \"Träger \\\"A\\\"\"\n";
  header.overrides = {"solver.max_steps=3"};
  header.inputs = {{"../discs.h5", "abcd"}};
  header.seed = 17;
  header.state_hash = "1234";
  header.step = 9'007'199'254'740'993;  // not a double
  header.time = 0.1 + 0.2;
  header.array_lengths = {{"nodes.velocity", 12}, {"particles.radius", std::numeric_limits<std::uint64_t>::max()}};
  return header;
}

/// An archive is any bytes: zeros and all.
std::string example_payload() {
  std::string payload;
  for (int i = 0; i < 80; ++i) {
    payload += static_cast<char>(i * 7 % 256);
  }
  return payload;
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// The answer to reading a file with this content; empty if it is taken for a good one.
std::string refusal(const fs::path& path, const std::string& content) {
  put(path, content);
  try {
    ligament::read_checkpoint(path);
  } catch (const ligament::FileError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string written(const fs::path& path, const CheckpointHeader& header = example_header(),
                    const std::string& payload = example_payload()) {
  ligament::write_checkpoint(path, header, payload);
  return content_of(path);
}

}  // namespace

TEST_CASE("a checkpoint comes back as it was written") {
  const fs::path path = scratch_folder("checkpoint_file") / "round_trip.ckpt";
  const CheckpointHeader header = example_header();
  ligament::write_checkpoint(path, header, example_payload());

  const auto checkpoint = ligament::read_checkpoint(path);
  CHECK(checkpoint.payload == example_payload());
  CHECK(checkpoint.header.program_version == header.program_version);
  CHECK(checkpoint.header.build == header.build);
  CHECK(checkpoint.header.compiler == header.compiler);
  CHECK(checkpoint.header.run_id == header.run_id);
  CHECK(checkpoint.header.case_hash == header.case_hash);
  CHECK(checkpoint.header.case_text == header.case_text);
  CHECK(checkpoint.header.overrides == header.overrides);
  CHECK(checkpoint.header.inputs == header.inputs);
  CHECK(checkpoint.header.seed == header.seed);
  CHECK(checkpoint.header.state_hash == header.state_hash);
  CHECK(checkpoint.header.step == header.step);
  CHECK(checkpoint.header.time == header.time);
  CHECK(checkpoint.header.array_lengths == header.array_lengths);
  CHECK(checkpoint.header.word_size == static_cast<int>(sizeof(void*)));
  CHECK(checkpoint.header.boost_version == ligament::program_boost_version());
  CHECK(ligament::read_checkpoint_header(path).state_hash == header.state_hash);
}

TEST_CASE("a checkpoint may have an empty payload") {
  const fs::path path = scratch_folder("checkpoint_file") / "empty_payload.ckpt";
  written(path, example_header(), "");
  CHECK(ligament::read_checkpoint(path).payload.empty());
}

TEST_CASE("the first bytes of a checkpoint can be read by eye") {
  const std::string content = written(scratch_folder("checkpoint_file") / "by_eye.ckpt");
  CHECK(content.starts_with("LIGAMENT CHECKPOINT\n"));
  CHECK(contains(content.substr(0, 200), "\"program_version\": \"0.1.0\""));
}

TEST_CASE("a checkpoint cut short anywhere is called truncated") {
  const fs::path path = scratch_folder("checkpoint_file") / "cut.ckpt";
  const std::string content = written(path);
  for (std::size_t size = 0; size < content.size(); ++size) {
    const std::string answer = refusal(path, content.substr(0, size));
    CAPTURE(size);
    REQUIRE(contains(answer, path.string()));
    REQUIRE(contains(answer, "is truncated"));
    REQUIRE_THROWS_AS(ligament::read_checkpoint_header(path), ligament::FileError);
  }
}

TEST_CASE("every flipped bit of a checkpoint is found") {
  const fs::path path = scratch_folder("checkpoint_file") / "flipped.ckpt";
  const std::string content = written(path);
  REQUIRE(refusal(path, content).empty());
  for (std::size_t bit = 0; bit < 8 * content.size(); ++bit) {
    std::string flipped = content;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    const std::string answer = refusal(path, flipped);
    CAPTURE(bit);
    CAPTURE(answer);
    REQUIRE(contains(answer, path.string()));
    const bool named = contains(answer, "damaged") || contains(answer, "truncated") || contains(answer, "version");
    REQUIRE(named);
  }
}

TEST_CASE("bytes after the end of a checkpoint are damage") {
  const fs::path path = scratch_folder("checkpoint_file") / "longer.ckpt";
  CHECK(contains(refusal(path, written(path) + "x"), "is damaged: 1 bytes follow"));
}

TEST_CASE("a length beyond any memory is a truncation, not an allocation") {
  const fs::path path = scratch_folder("checkpoint_file") / "long_header.ckpt";
  std::string content = written(path);
  std::memset(content.data() + header_length_offset, 0xff, sizeof(std::uint64_t));
  CHECK(contains(refusal(path, content), "within the header"));
}

TEST_CASE("another file is not taken for a checkpoint") {
  const fs::path path = scratch_folder("checkpoint_file") / "other.ckpt";
  CHECK(contains(refusal(path, "step,time_s\n0,0\n"), "is not a ligament checkpoint"));
}

TEST_CASE("a checkpoint of another format version is named as such") {
  const fs::path path = scratch_folder("checkpoint_file") / "format.ckpt";
  std::string content = written(path);
  content[version_offset] = 7;
  CHECK(contains(refusal(path, content), "it has version 7, this program reads version 2"));
}

TEST_CASE("a checkpoint of another word size can be described but not resumed") {
  const fs::path path = scratch_folder("checkpoint_file") / "word_size.ckpt";
  CheckpointHeader header = example_header();
  header.word_size = 4;
  CHECK(contains(refusal(path, written(path, header)), "another word size: 4 bytes"));
  CHECK(ligament::read_checkpoint_header(path).word_size == 4);
}

TEST_CASE("a checkpoint of another Boost version can be described but not resumed") {
  const fs::path path = scratch_folder("checkpoint_file") / "boost.ckpt";
  CheckpointHeader header = example_header();
  header.boost_version = "1_00";
  CHECK(contains(refusal(path, written(path, header)), "another Boost version: 1_00"));
  CHECK(ligament::read_checkpoint_header(path).boost_version == "1_00");
}

TEST_CASE("a header that lacks a number is refused in words") {
  const fs::path path = scratch_folder("checkpoint_file") / "no_time.ckpt";
  CheckpointHeader header = example_header();
  header.time = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refusal(path, written(path, header)), "has a header that this program does not understand"));
}

TEST_CASE("a missing checkpoint is a FileError") {
  CHECK_THROWS_AS(ligament::read_checkpoint(scratch_folder("checkpoint_file") / "missing.ckpt"), ligament::FileError);
}
