#include "ensemble/mean_curve.hpp"

#include <algorithm>

namespace ligament {

Curve forward_part(std::span<const double> x, std::span<const double> y) {
  Curve curve;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!curve.x.empty() && x[i] <= curve.x.back()) continue;
    curve.x.push_back(x[i]);
    curve.y.push_back(y[i]);
  }
  return curve;
}

double value_at(const Curve& curve, double x) {
  const auto above = std::upper_bound(curve.x.begin(), curve.x.end(), x);
  if (above == curve.x.begin()) return curve.y.front();
  if (above == curve.x.end()) return curve.y.back();
  const auto high = static_cast<std::size_t>(above - curve.x.begin());
  const std::size_t low = high - 1;
  const double share = (x - curve.x[low]) / (curve.x[high] - curve.x[low]);
  return curve.y[low] + share * (curve.y[high] - curve.y[low]);
}

std::vector<BandPoint> band_of(std::span<const Curve> curves, std::size_t n_points) {
  const bool has_empty = std::any_of(curves.begin(), curves.end(), [](const Curve& curve) { return curve.x.empty(); });
  if (curves.empty() || has_empty) return {};
  double begin = curves.front().x.front();
  double end = curves.front().x.back();
  for (const Curve& curve : curves) {
    begin = std::max(begin, curve.x.front());
    end = std::min(end, curve.x.back());
  }
  if (!(begin < end)) return {};
  std::vector<BandPoint> band;
  std::vector<double> values(curves.size());
  for (std::size_t i = 0; i < n_points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n_points - 1);
    const double x = begin + share * (end - begin);
    std::transform(curves.begin(), curves.end(), values.begin(),
                   [x](const Curve& curve) { return value_at(curve, x); });
    band.push_back({x, statistics_of(values)});
  }
  return band;
}

}  // namespace ligament
