#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/state_hash.hpp"
#include "io/checkpoint_file.hpp"
#include "io/state_archive.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace ligament {
namespace {

constexpr std::size_t header_length_at = 24;  ///< after first line and format version

/// Lengths that fit and a checksum that is right: without them nothing that lies behind would ever be reached.
std::string repaired(std::string content) {
  constexpr std::size_t n_length = sizeof(std::uint64_t);
  if (content.size() >= header_length_at + 2 * n_length) {
    const std::uint64_t n_left = content.size() - header_length_at - 2 * n_length;
    std::uint64_t n_header = 0;
    std::memcpy(&n_header, content.data() + header_length_at, n_length);
    n_header = std::min(n_header, n_left);
    std::memcpy(content.data() + header_length_at, &n_header, n_length);
    const std::uint64_t n_payload = n_left - n_header;
    std::memcpy(content.data() + header_length_at + n_length + n_header, &n_payload, n_length);
  }
  XXH128_canonical_t checksum;
  XXH128_canonicalFromHash(&checksum, XXH3_128bits(content.data(), content.size()));
  content.append(reinterpret_cast<const char*>(checksum.digest), sizeof(checksum.digest));
  return content;
}

/// The laws that the names of the history tell of: <material>.bond.<variable>. None if some have no history.
std::vector<LawBinding> laws_of(const ContactTable& contacts) {
  std::vector<LawBinding> laws;
  for (const HistoryColumn& column : contacts.history) {
    const std::string name = column.name.substr(0, column.name.rfind('.'));
    if (laws.empty() || laws.back().name != name) laws.push_back({name, nullptr, 0});
    ++laws.back().n_history;
  }
  return laws.size() + 1 == contacts.law_begin.size() ? laws : std::vector<LawBinding>();
}

/// A model of as many bodies as the checkpoint has, and with its laws.
Model model_of(const State& state) {
  Model model;
  model.laws = laws_of(state.particle_contacts);
  model.particles.radius.assign(state.particles.translation.mass.size(), 1.0);
  model.particles.position.resize(model.particles.radius.size());
  model.nodes.position.resize(state.nodes.translation.mass.size());
  model.beam_nodes.position.resize(state.beam_nodes.translation.mass.size());
  model.facets.nodes.resize(model.nodes.size());
  return model;
}

}  // namespace
}  // namespace ligament

/// Any bytes as a checkpoint without its checksum, which the harness adds: it is read, or refused with an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ligament;
  try {
    const Checkpoint checkpoint =
        parse_checkpoint("fuzzed.ckpt", repaired(std::string(reinterpret_cast<const char*>(data), size)));
    State state = load_unknown_state(checkpoint.payload, checkpoint.header.array_lengths);
    static_cast<void>(state_hash(state));
    load_state(checkpoint.payload, checkpoint.header.array_lengths, model_of(state), state);
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
