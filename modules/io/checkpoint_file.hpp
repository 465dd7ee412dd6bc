#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligament {

/// Bytes of a pointer in this program; an archive is read only by programs of the same word size.
int program_word_size();

/// Boost version this program was compiled with, as in "1_74".
std::string program_boost_version();

/// What a checkpoint says about itself in plain text, ahead of the archive of the state.
struct CheckpointHeader {
  std::string program_version;
  std::string build;
  std::string compiler;
  std::string run_id;
  std::string case_hash;
  std::string case_text;               ///< the case as it was read, defaults and overrides in
  std::vector<std::string> overrides;  ///< each as key=value
  /// Path in the case and hash of the content of every file that the case names.
  std::vector<std::pair<std::string, std::string>> inputs;
  std::int64_t seed = 0;  ///< of the random numbers of the generators
  std::string state_hash;
  std::int64_t step = 0;
  double time = 0.0;  ///< s
  /// Number of entries of every array of the state, in the order of the archive, to be compared with the model before
  /// the archive is read.
  std::vector<std::pair<std::string, std::uint64_t>> array_lengths;
  int word_size = program_word_size();
  std::string boost_version = program_boost_version();
};

struct Checkpoint {
  CheckpointHeader header;
  std::string payload;  ///< archive of the state, as it was given to write_checkpoint
};

/// Writes header and payload in one atomic step: after a failure the file at `path` is what it was before.
/// Throws FileError when the file can't be written.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header, std::string_view payload);

/// Reads a checkpoint whose every byte was verified. Throws FileError, naming the file, when it can't be read, is no
/// checkpoint, is truncated or damaged, or was written by another format version, word size or Boost version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The same for content that was read already; `path` is for messages.
Checkpoint parse_checkpoint(const std::filesystem::path& path, std::string content);

/// The header alone, verified like read_checkpoint, but of any word size and Boost version.
CheckpointHeader read_checkpoint_header(const std::filesystem::path& path);

}  // namespace ligament
