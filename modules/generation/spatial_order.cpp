#include "generation/spatial_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ligament {
namespace {

struct Key {
  double strip;
  double column;
  Vector position;

  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.strip, a.column, a.position.y, a.position.x) <
           std::tie(b.strip, b.column, b.position.y, b.position.x);
  }
};

}  // namespace

void sort_spatially(Packing& packing) {
  if (packing.size() == 0) return;
  const double cell = 4.0 * *std::max_element(packing.radius.begin(), packing.radius.end());
  std::vector<Key> keys;
  for (const Vector& position : packing.position) {
    keys.push_back({std::floor(position.y / cell), std::floor(position.x / cell), position});
  }
  std::vector<std::size_t> order(packing.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  Packing sorted;
  for (const std::size_t i : order) {
    sorted.position.push_back(packing.position[i]);
    sorted.radius.push_back(packing.radius[i]);
  }
  sorted.report = std::move(packing.report);
  packing = std::move(sorted);
}

}  // namespace ligament
