#include "run/compare_states.hpp"

#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "core/fields.hpp"

namespace ligament {
namespace {

std::string text_of(double value) { return fmt::format("{:.17g}", value); }
std::string text_of(std::int64_t value) { return fmt::format("{}", value); }
std::string text_of(Index value) { return fmt::format("{}", value); }
std::string text_of(BondState value) { return fmt::format("{}", static_cast<int>(value)); }
std::string text_of(const Vector& value) {
  const auto [x, y, z] = to_space(value);
  return fmt::format("({:.17g}, {:.17g})", x, y);
}
std::string text_of(const PathSum& sum) {
  return fmt::format("{:.17g} (compensation {:.17g}, pending {:.17g})", sum.value, sum.compensation, sum.pending);
}

/// A field as the bytes of its entries, with a way to print one.
struct FieldView {
  std::string name;
  const void* data = nullptr;
  std::size_t count = 0;
  std::size_t entry_size = 0;
  std::string (*text)(const void* entry) = nullptr;

  [[nodiscard]] const char* entry(std::size_t i) const { return static_cast<const char*>(data) + i * entry_size; }
};

template <class T>
FieldView view_of(const std::string& name, const T* data, std::size_t count) {
  return {name, data, count, sizeof(T), [](const void* entry) { return text_of(*static_cast<const T*>(entry)); }};
}

std::vector<FieldView> views_of(const State& state) {
  std::vector<FieldView> views;
  visit_fields(state, [&]<class T>(const std::string& name, const T& field, FieldRole) {
    if constexpr (requires { field.data(); }) {
      views.push_back(view_of(name, field.data(), field.size()));
    } else {
      views.push_back(view_of(name, &field, 1));
    }
  });
  return views;
}

}  // namespace

std::optional<std::string> first_difference(const State& a, const State& b) {
  const auto fields_a = views_of(a);
  const auto fields_b = views_of(b);
  for (std::size_t i = 0; i < std::min(fields_a.size(), fields_b.size()); ++i) {
    const FieldView& x = fields_a[i];
    const FieldView& y = fields_b[i];
    if (x.name != y.name) return fmt::format("field {} against field {}", x.name, y.name);
    if (x.count != y.count) return fmt::format("{}: {} entries against {}", x.name, x.count, y.count);
    for (std::size_t k = 0; k < x.count; ++k) {
      if (std::memcmp(x.entry(k), y.entry(k), x.entry_size) == 0) continue;
      return fmt::format("{}[{}]: {} against {}", x.name, k, x.text(x.entry(k)), y.text(y.entry(k)));
    }
  }
  if (fields_a.size() != fields_b.size()) return fmt::format("{} fields against {}", fields_a.size(), fields_b.size());
  return std::nullopt;
}

}  // namespace ligament
