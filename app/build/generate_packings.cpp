#include "build/generate_packings.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "generation/spatial_order.hpp"

namespace ligament {

Rectangle rectangle_of(const ZoneTable& zone) { return {to_vector(zone.from), to_vector(zone.to)}; }

std::vector<Packing> generate_packings(Case& input) {
  std::vector<Packing> packings;
  for (const auto& [zone, view] : input.zones) {
    try {
      packings.push_back(
          zone.generator->generate(rectangle_of(zone), static_cast<std::uint64_t>(input.generation.seed)));
      sort_spatially(packings.back());
    } catch (const InputError& error) {
      input.file.add_error(input.file.position(view), fmt::format("zone '{}': {}", zone.name, error.what()));
    }
  }
  input.file.throw_collected_errors();
  return packings;
}

}  // namespace ligament
