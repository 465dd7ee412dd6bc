#include <doctest/doctest.h>

#include <string>

#include "core/error.hpp"
#include "core/state_hash.hpp"
#include "io/checkpoint_file.hpp"
#include "io/state_archive.hpp"

/// Checkpoints of earlier programs, kept as they were written: they load to the same bits, or are refused in words.
namespace ligament {
namespace {

std::string golden(int format_version) {
  return LIGAMENT_SOURCE_DIR "/tests/data/checkpoint_format_" + std::to_string(format_version) + ".ckpt";
}

TEST_CASE("a checkpoint of format 1 is refused with both versions") {
  const std::string refusal = "checkpoint file '" + golden(1) +
                              "' was written by another format version: it has version 1, this program reads version 2";
  CHECK_THROWS_WITH_AS(read_checkpoint(golden(1)), refusal.c_str(), FileError);
  CHECK_THROWS_WITH_AS(read_checkpoint_header(golden(1)), refusal.c_str(), FileError);
}

TEST_CASE("a checkpoint of format 2 tells where it came from") {
  const CheckpointHeader header = read_checkpoint_header(golden(2));
  CHECK(header.program_version == "0.1.0");
  CHECK(header.step == 40);
  CHECK(header.seed == 1);
  CHECK(header.state_hash == "3acd390f57987e98e059115c11a38602");
  CHECK(header.case_text.find("young_modulus = \"2e+10 Pa\"") != std::string::npos);
}

TEST_CASE("a checkpoint of format 2 loads to the same bits, or is refused in words") {
  std::string answer;
  try {
    const Checkpoint checkpoint = read_checkpoint(golden(2));
    answer = state_hash(load_unknown_state(checkpoint.payload, checkpoint.header.array_lengths));
  } catch (const FileError& error) {
    answer = error.what();
  }
  CAPTURE(answer);
  const auto says = [&answer](const char* words) { return answer.find(words) != std::string::npos; };
  // Words for another Boost version, another word size, and fields that the state had then or has since.
  const bool is_refused = says("another Boost version") || says("another word size") ||
                          says("the checkpoint lacks the field") || says("the checkpoint has a field");
  CHECK((is_refused || answer == "3acd390f57987e98e059115c11a38602"));
}

}  // namespace
}  // namespace ligament
