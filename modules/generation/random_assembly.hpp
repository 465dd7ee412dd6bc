#pragma once

#include <optional>

#include "core/generator.hpp"

namespace ligament {

class RandomNumbers;

/// Discs of random radii in random order, squeezed into the zone: thrown in at 40 % of their size, grown in steps, and
/// let push each other until their overlaps are even. Pairs that overlap at the end are bonded.
class RandomAssembly : public Generator {
 public:
  enum class Radii { uniform, log_uniform };

  void declare(Parameters& parameters) override;
  [[nodiscard]] Packing generate(const Rectangle& region, std::uint64_t seed) const override;
  [[nodiscard]] double default_detection_gap() const override { return 0.0; }
  [[nodiscard]] double default_interface_gap() const override { return 0.0; }

 private:
  void check(const Vector& size) const;
  [[nodiscard]] double draw_radius(RandomNumbers& random) const;
  /// For a zone of this area (m²), in descending order.
  [[nodiscard]] Field<double> draw_radii(double area, RandomNumbers& random) const;
  [[nodiscard]] Field<double> draw_by_count(double area, RandomNumbers& random) const;
  /// Of discs whose areas add up to what is wanted (m²).
  [[nodiscard]] Field<double> draw_by_area(double wanted, RandomNumbers& random) const;
  [[nodiscard]] std::vector<ReportEntry> report(const Packing& packing, const Rectangle& region) const;

  double smallest_radius_ = 0.0;
  double largest_radius_ = 0.0;
  Radii radii_ = Radii::uniform;
  std::optional<std::int64_t> count_;
  std::optional<double> area_ratio_;
};

}  // namespace ligament
