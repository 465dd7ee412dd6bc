#include "generation/packing_report.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace ligament {

std::vector<ReportEntry> packing_report(const Packing& packing, const Rectangle& region) {
  const auto [smallest, largest] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  const double count = static_cast<double>(packing.size());
  const double sum = std::accumulate(packing.radius.begin(), packing.radius.end(), 0.0);
  const double squares = std::inner_product(packing.radius.begin(), packing.radius.end(), packing.radius.begin(), 0.0);
  const Vector size = region.size();
  return {{"n_particles", count},
          {"smallest_radius_m", *smallest},
          {"mean_radius_m", sum / count},
          {"largest_radius_m", *largest},
          {"area_ratio", std::numbers::pi * squares / (size.x * size.y)}};
}

}  // namespace ligament
