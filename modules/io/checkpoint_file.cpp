#include "io/checkpoint_file.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <boost/version.hpp>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace ligament {

namespace {

// The payload is a native binary archive, and the numbers of the container are copied as they lie in memory.
static_assert(std::endian::native == std::endian::little, "checkpoints hold little-endian numbers");

constexpr std::string_view magic = "LIGAMENT CHECKPOINT\n";
constexpr std::uint32_t format_version = 2;
constexpr std::size_t checksum_size = sizeof(XXH128_canonical_t);

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw FileError(fmt::format("checkpoint file '{}' {}", path.string(), what));
}

/// The only list of the header's fields: writing and reading follow from it.
template <class Header, class Visitor>
void visit_header(Header& header, Visitor&& visit) {
  visit("program_version", header.program_version);
  visit("build", header.build);
  visit("compiler", header.compiler);
  visit("run_id", header.run_id);
  visit("case_hash", header.case_hash);
  visit("case_text", header.case_text);
  visit("overrides", header.overrides);
  visit("inputs", header.inputs);
  visit("seed", header.seed);
  visit("state_hash", header.state_hash);
  visit("step", header.step);
  visit("time", header.time);
  visit("array_lengths", header.array_lengths);
  visit("word_size", header.word_size);
  visit("boost_version", header.boost_version);
}

std::string header_to_text(const CheckpointHeader& header) {
  nlohmann::ordered_json json;
  visit_header(header, [&](const char* name, const auto& value) { json[name] = value; });
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Time alone is a fraction; the library would convert one to a whole number unchecked.
void check_numbers(const std::filesystem::path& path, const nlohmann::json& header) {
  const nlohmann::json numbers = header.flatten();
  for (const auto& [place, value] : numbers.items()) {
    if (value.is_number_float() && place != "/time") {
      fail(path, fmt::format("has {} in its header at '{}', where a whole number belongs", value.dump(), place));
    }
  }
}

CheckpointHeader header_from_text(const std::filesystem::path& path, std::string_view text) {
  try {
    CheckpointHeader header;
    const auto json = nlohmann::json::parse(text);
    check_numbers(path, json);
    visit_header(header, [&](const char* name, auto& value) { json.at(name).get_to(value); });
    return header;
  } catch (const nlohmann::json::exception& error) {
    fail(path, fmt::format("has a header that this program does not understand: {}", error.what()));
  }
}

template <class Number>
void append_number(std::string& content, Number number) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &number, sizeof(Number));
  content.append(bytes.data(), bytes.size());
}

/// Of these pieces as one.
std::string checksum(std::initializer_list<std::string_view> pieces) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  XXH3_128bits_reset(state.get());
  for (const std::string_view piece : pieces) XXH3_128bits_update(state.get(), piece.data(), piece.size());
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
  return std::string(reinterpret_cast<const char*>(canonical.digest), checksum_size);
}

/// Takes a verified file apart from front to back; whatever is asked for beyond its end is reported as a truncation.
class Reader {
 public:
  Reader(const std::filesystem::path& path, std::string_view content) : path_(path), content_(content) {}

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return content_.size() - position_; }

  std::string_view take(std::uint64_t size, std::string_view what) {
    if (size > remaining()) {
      fail(path_, fmt::format("is truncated: it ends after {} bytes, within the {}", content_.size(), what));
    }
    const auto bytes = content_.substr(position_, size);
    position_ += size;
    return bytes;
  }

  template <class Number>
  Number take_number(std::string_view what) {
    Number number;
    std::memcpy(&number, take(sizeof(Number), what).data(), sizeof(Number));
    return number;
  }

 private:
  const std::filesystem::path& path_;
  std::string_view content_;
  std::size_t position_ = 0;
};

struct Layout {
  std::string_view header_text;
  std::size_t payload_begin;
  std::size_t payload_size;
};

void require_magic(const std::filesystem::path& path, std::string_view content) {
  if (content.substr(0, magic.size()) != magic.substr(0, content.size())) {
    fail(path, "is not a ligament checkpoint, or its first bytes are damaged");
  }
}

/// Sizes, magic, format version, lengths and checksum, in this order; nothing of the header is looked at before.
Layout verified_layout(const std::filesystem::path& path, std::string_view content) {
  require_magic(path, content);
  Reader reader(path, content);
  reader.take(magic.size(), "first line");
  const auto version = reader.take_number<std::uint32_t>("format version");
  if (version != format_version) {
    fail(path, fmt::format("was written by another format version: it has version {}, this program reads version {}",
                           version, format_version));
  }
  Layout layout{};
  layout.header_text = reader.take(reader.take_number<std::uint64_t>("header length"), "header");
  const auto payload_size = reader.take_number<std::uint64_t>("payload length");
  layout.payload_begin = reader.position();
  layout.payload_size = reader.take(payload_size, "payload").size();
  const auto covered = content.substr(0, reader.position());
  const auto stored = reader.take(checksum_size, "checksum");
  if (reader.remaining() != 0) {
    fail(path, fmt::format("is damaged: {} bytes follow where it should end", reader.remaining()));
  }
  if (stored != checksum({covered})) {
    fail(path, "is damaged: its content does not match its checksum");
  }
  return layout;
}

void require_readable_archive(const std::filesystem::path& path, const CheckpointHeader& header) {
  if (header.word_size != program_word_size()) {
    fail(path, fmt::format("was written by a program of another word size: {} bytes, this program has {}",
                           header.word_size, program_word_size()));
  }
  if (header.boost_version != program_boost_version()) {
    fail(path, fmt::format("was written with another Boost version: {}, this program has {}", header.boost_version,
                           program_boost_version()));
  }
}

}  // namespace

int program_word_size() { return static_cast<int>(sizeof(void*)); }

std::string program_boost_version() { return BOOST_LIB_VERSION; }

void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header, std::string_view payload) {
  const std::string header_text = header_to_text(header);
  std::string begin(magic);
  append_number(begin, format_version);
  append_number(begin, std::uint64_t{header_text.size()});
  begin += header_text;
  append_number(begin, std::uint64_t{payload.size()});
  // The payload can fill much of the memory: it is written from where it is, never copied.
  write_atomically(path, {begin, payload, checksum({begin, payload})});
}

Checkpoint read_checkpoint(const std::filesystem::path& path) { return parse_checkpoint(path, read_file(path)); }

Checkpoint parse_checkpoint(const std::filesystem::path& path, std::string content) {
  const Layout layout = verified_layout(path, content);
  Checkpoint checkpoint;
  checkpoint.header = header_from_text(path, layout.header_text);
  require_readable_archive(path, checkpoint.header);
  // The payload can fill much of the memory: it is moved within the string it was read into, never copied.
  content.resize(layout.payload_begin + layout.payload_size);
  content.erase(0, layout.payload_begin);
  checkpoint.payload = std::move(content);
  return checkpoint;
}

CheckpointHeader read_checkpoint_header(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  return header_from_text(path, verified_layout(path, content).header_text);
}

}  // namespace ligament
