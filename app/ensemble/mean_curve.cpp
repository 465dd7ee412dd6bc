#include "ensemble/mean_curve.hpp"

#include <algorithm>

namespace ligament {

Curve forward_part(std::span<const double> x, std::span<const double> y) {
  Curve curve;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!curve.abscissa.empty() && x[i] <= curve.abscissa.back()) continue;
    curve.abscissa.push_back(x[i]);
    curve.ordinate.push_back(y[i]);
  }
  return curve;
}

double value_at(const Curve& curve, double x) {
  const auto above = std::upper_bound(curve.abscissa.begin(), curve.abscissa.end(), x);
  if (above == curve.abscissa.begin()) return curve.ordinate.front();
  if (above == curve.abscissa.end()) return curve.ordinate.back();
  const auto high = static_cast<std::size_t>(above - curve.abscissa.begin());
  const std::size_t low = high - 1;
  const double share = (x - curve.abscissa[low]) / (curve.abscissa[high] - curve.abscissa[low]);
  return curve.ordinate[low] + share * (curve.ordinate[high] - curve.ordinate[low]);
}

std::vector<BandPoint> band_of(std::span<const Curve> curves, std::size_t n_points) {
  const bool has_empty =
      std::any_of(curves.begin(), curves.end(), [](const Curve& curve) { return curve.abscissa.empty(); });
  if (curves.empty() || has_empty) return {};
  double begin = curves.front().abscissa.front();
  double end = curves.front().abscissa.back();
  for (const Curve& curve : curves) {
    begin = std::max(begin, curve.abscissa.front());
    end = std::min(end, curve.abscissa.back());
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
