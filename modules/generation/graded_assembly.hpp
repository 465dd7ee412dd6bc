#pragma once

#include <optional>

#include "core/generator.hpp"
#include "generation/grading.hpp"

namespace ligament {

/// Concrete: grains by a grading curve, squeezed into the zone, and discs of one size in the voids between them. Pairs
/// that overlap at the end are bonded.
class GradedAssembly : public Generator {
 public:
  /// What the grading says about the particles: the proportions of the grains that fill the zone, or the grains
  /// themselves, with discs of the threshold diameter between them.
  enum class Interpretation { fill, literal };

  void declare(Parameters& parameters) override;
  [[nodiscard]] Packing generate(const Rectangle& region, std::uint64_t seed) const override;
  [[nodiscard]] double default_detection_gap() const override { return 0.0; }
  [[nodiscard]] double default_interface_gap() const override { return 0.0; }

 private:
  void check(const Vector& size) const;
  /// The classes, with the area of their grains over that of the zone in place of their share of mass.
  [[nodiscard]] std::vector<SieveClass> wanted_classes() const;
  [[nodiscard]] double literal_factor() const;
  /// Radii (m) of discs of the threshold diameter that bring the area ratio of the grains to what is asked for.
  [[nodiscard]] Field<double> discs_between(double area_of_grains, double area_of_zone) const;

  Grading grading_;
  Interpretation interpretation_ = Interpretation::fill;
  std::optional<double> aggregate_content_;
  double grain_density_ = 2650.0;
  double area_ratio_ = 1.10;
  double void_diameter_ = 0.0;
  double smallest_void_radius_ = 0.0;
};

}  // namespace ligament
