#include "generation/void_elimination.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "generation/disc_growth.hpp"
#include "generation/voids.hpp"

namespace ligament {
namespace {

/// Fills the voids, the largest first, those left out that the discs before have made too small.
void fill(Packing& packing, const std::vector<Circle>& voids, double radius, double smallest_void) {
  const std::size_t n_before = packing.size();
  for (const Circle& hole : voids) {
    bool is_left = true;
    for (std::size_t i = n_before; i < packing.size() && is_left; ++i) {
      is_left = norm(packing.position[i] - hole.centre) - radius > smallest_void;
    }
    if (!is_left) continue;
    packing.position.push_back(hole.centre);
    packing.radius.push_back(radius);
  }
}

}  // namespace

std::size_t eliminate_voids(Packing& packing, const Vector& size, double radius, double smallest_void) {
  constexpr int most_rounds = 1000;
  const std::size_t n_before = packing.size();
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Circle> voids = find_voids(packing.position, packing.radius, size, smallest_void);
    if (voids.empty()) return packing.size() - n_before;
    fill(packing, voids, radius, smallest_void);
    settle(packing, size);
  }
  throw InputError(
      fmt::format("voids above {:g} m are left after {} rounds of filling them with discs of {:g} m radius: a larger "
                  "'smallest_void_radius' would do",
                  smallest_void, most_rounds, radius));
}

}  // namespace ligament
