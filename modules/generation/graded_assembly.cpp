#include "generation/graded_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/block_sum.hpp"
#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/contact_report.hpp"
#include "generation/disc_growth.hpp"
#include "generation/packing_report.hpp"
#include "generation/particle_limit.hpp"
#include "generation/spatial_order.hpp"
#include "generation/void_elimination.hpp"

namespace ligament {
namespace {

/// choice: beyond this, discs overlap with the neighbours of their neighbours.
constexpr double largest_area_ratio = 1.5;

double disc_area(double radius) { return std::numbers::pi * radius * radius; }

double area_of(const Field<double>& radii) {
  return block_sum(radii.size(), [&](std::size_t i) { return disc_area(radii[i]); });
}

double sum_of_shares(const std::vector<SieveClass>& classes) {
  double sum = 0.0;
  for (const SieveClass& sieve_class : classes) sum += sieve_class.share;
  return sum;
}

ReportEntry class_entry(const SieveClass& sieve_class, double area_ratio) {
  return {fmt::format("area_ratio_{:g}_{:g}_mm", 1e3 * sieve_class.from, 1e3 * sieve_class.to), area_ratio,
          sieve_class.share};
}

void append(std::vector<ReportEntry>& entries, std::vector<ReportEntry> more) {
  for (ReportEntry& entry : more) entries.push_back(std::move(entry));
}

}  // namespace

void GradedAssembly::declare(Parameters& parameters) {
  grading_.declare(parameters);
  parameters.choice(
      "interpretation", interpretation_, {{"fill", Interpretation::fill}, {"literal", Interpretation::literal}},
      "'fill': the classes from the threshold on fill the zone, in proportion to their shares; 'literal': "
      "there are as many grains as the aggregate content says, and discs of the threshold diameter "
      "between them");
  parameters
      .quantity("aggregate_content", aggregate_content_, "kg/m3",
                "mass of the aggregate in the concrete; needed for interpretation = \"literal\"")
      .greater_than(0.0);
  parameters.quantity("grain_density", grain_density_, "kg/m3", "density of the grains, for \"literal\"")
      .greater_than(0.0);
  parameters
      .number("area_ratio", area_ratio_,
              "area of the particles over that of the zone, overlaps counted twice, before voids are filled")
      .greater_than(0.0)
      .at_most(largest_area_ratio);
  parameters.quantity("void_diameter", void_diameter_, "m", "diameter of the discs that are put into voids")
      .required()
      .greater_than(0.0);
  parameters
      .quantity("smallest_void_radius", smallest_void_radius_, "m",
                "voids where an empty circle larger than this finds room are filled, but at the border")
      .required()
      .greater_than(0.0);
}

Packing GradedAssembly::generate(const Rectangle& region, std::uint64_t seed) const {
  const Vector size = region.size();
  check(size);
  const double area_of_zone = size.x * size.y;
  RandomNumbers random(seed);
  Field<double> radii;
  std::vector<ReportEntry> entries;
  for (const SieveClass& sieve_class : wanted_classes()) {
    const Field<double> grains = draw_grains(sieve_class, sieve_class.share * area_of_zone, random);
    radii.insert(radii.end(), grains.begin(), grains.end());
    entries.push_back(class_entry(sieve_class, area_of(grains) / area_of_zone));
  }
  const Field<double> between = discs_between(area_of(radii), area_of_zone);
  radii.insert(radii.end(), between.begin(), between.end());
  entries.push_back({"area_ratio_before_voids", area_of(radii) / area_of_zone, area_ratio_});
  std::sort(radii.begin(), radii.end(), std::greater<>());

  Packing packing = grow_discs(radii, size, random);
  const VoidFilling filling{0.5 * void_diameter_, smallest_void_radius_};
  entries.push_back({"n_discs_in_voids", static_cast<double>(eliminate_voids(packing, size, filling))});
  entries.push_back({"largest_void_radius_m", largest_void_left(packing, size, filling), smallest_void_radius_});
  for (Vector& centre : packing.position) centre += region.from;
  sort_spatially(packing);  // so that the sums of the report are those of the particles as they will be numbered
  append(entries, packing_report(packing, region));
  append(entries, contact_report(packing, default_detection_gap()));
  packing.report = std::move(entries);
  return packing;
}

void GradedAssembly::check(const Vector& size) const {
  grading_.check();
  const double largest = std::max(grading_.classes().back().to, void_diameter_);
  if (largest > std::min(size.x, size.y)) {
    throw InputError(fmt::format("discs of diameter {:g} m do not fit into {} m × {} m", largest, size.x, size.y));
  }
  if (interpretation_ == Interpretation::literal) {
    const double grains = sum_of_shares(wanted_classes());
    if (grains > area_ratio_) {
      throw InputError(
          fmt::format("the grains alone have {:.3g} times the area of the zone, more than the area ratio of {:g}: a "
                      "smaller aggregate content or a greater area ratio would do",
                      grains, area_ratio_));
    }
  }
  const double smallest = std::min(grading_.threshold_diameter(), void_diameter_);
  check_particle_count(area_ratio_ * size.x * size.y / disc_area(0.5 * smallest));
}

double GradedAssembly::literal_factor() const {
  if (aggregate_content_) return *aggregate_content_ / grain_density_;
  throw InputError("interpretation = \"literal\" needs 'aggregate_content'");
}

std::vector<SieveClass> GradedAssembly::wanted_classes() const {
  std::vector<SieveClass> classes = grading_.classes();
  const double factor =
      interpretation_ == Interpretation::literal ? literal_factor() : area_ratio_ / sum_of_shares(classes);
  for (SieveClass& sieve_class : classes) sieve_class.share *= factor;
  return classes;
}

Field<double> GradedAssembly::discs_between(double area_of_grains, double area_of_zone) const {
  if (interpretation_ == Interpretation::fill) return {};
  const double radius = 0.5 * grading_.threshold_diameter();
  const double missing = std::max(0.0, area_ratio_ * area_of_zone - area_of_grains);
  return Field<double>(static_cast<std::size_t>(std::lround(missing / disc_area(radius))), radius);
}

}  // namespace ligament
