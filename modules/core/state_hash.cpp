#include "core/state_hash.hpp"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <memory>
#include <type_traits>

#include "core/fields.hpp"

namespace ligament {
namespace {

/// Types with one bit pattern per value: no padding.
template <class T>
concept Hashable =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vector> || std::is_same_v<T, PathSum>;
static_assert(sizeof(PathSum) == 3 * sizeof(double) && sizeof(Vector) == dimension * sizeof(double));

class Hasher {
 public:
  Hasher() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

  /// The length is part of it: two fields that share their numbers otherwise are two states.
  template <Hashable T>
  void add(const Field<T>& field) {
    add(field.size());
    add_bytes(field.data(), field.size() * sizeof(T));
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(const T& value) { add_bytes(&value, sizeof(T)); }

  [[nodiscard]] std::string digest() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  void add_bytes(const void* data, std::size_t size) {
    if (size > 0) XXH3_128bits_update(state_.get(), data, size);
  }

  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace

std::string state_hash(const State& state) {
  Hasher hasher;
  visit_fields(state, [&](const std::string&, const auto& field, FieldRole role) {
    if (role == FieldRole::physics) hasher.add(field);
  });
  return hasher.digest();
}

}  // namespace ligament
