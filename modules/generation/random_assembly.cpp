#include "generation/random_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "core/block_sum.hpp"
#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/contact_report.hpp"
#include "generation/disc_growth.hpp"
#include "generation/packing_report.hpp"
#include "generation/particle_limit.hpp"
#include "generation/random_numbers.hpp"
#include "generation/spatial_order.hpp"

namespace ligament {
namespace {

/// choice: beyond this, discs overlap with the neighbours of their neighbours.
constexpr double largest_area_ratio = 1.5;

double disc_area(double radius) { return std::numbers::pi * radius * radius; }

}  // namespace

void RandomAssembly::declare(Parameters& parameters) {
  parameters.quantity("smallest_radius", smallest_radius_, "m", "least radius of the particles")
      .required()
      .greater_than(0.0);
  parameters.quantity("largest_radius", largest_radius_, "m", "greatest radius of the particles")
      .required()
      .greater_than(0.0);
  parameters.choice("radii", radii_, {{"uniform", Radii::uniform}, {"log_uniform", Radii::log_uniform}},
                    "distribution of the radii R between the two: all alike, or with density ~ 1/R");
  parameters.integer("count", count_, "number of particles; either this or area_ratio").at_least(1);
  parameters
      .number("area_ratio", area_ratio_,
              "area of the particles over that of the zone, overlaps counted twice, which whole particles come "
              "nearest to; either this or count")
      .greater_than(0.0)
      .at_most(largest_area_ratio);
}

Packing RandomAssembly::generate(const Rectangle& region, std::uint64_t seed) const {
  const Vector size = region.size();
  check(size);
  RandomNumbers random(seed);
  Packing packing = grow_discs(draw_radii(size.x * size.y, random), size, random);
  for (Vector& centre : packing.position) centre += region.from;
  sort_spatially(packing);  // so that the sums of the report are those of the particles as they will be numbered
  packing.report = report(packing, region);
  return packing;
}

void RandomAssembly::check(const Vector& size) const {
  if (smallest_radius_ > largest_radius_) {
    throw InputError(
        fmt::format("the smallest radius, {} m, is larger than the largest, {} m", smallest_radius_, largest_radius_));
  }
  // choice: beyond this, drawing by rejection takes longer than packing.
  constexpr double widest_range = 1000.0;
  if (radii_ == Radii::log_uniform && largest_radius_ > widest_range * smallest_radius_) {
    throw InputError(fmt::format("log-uniform radii may differ by a factor of {} at most; these differ by {:.4g}",
                                 widest_range, largest_radius_ / smallest_radius_));
  }
  if (count_.has_value() == area_ratio_.has_value()) {
    throw InputError(fmt::format("a random assembly needs either 'count' or 'area_ratio'; {} given",
                                 count_ ? "both are" : "none is"));
  }
  if (2.0 * largest_radius_ > std::min(size.x, size.y)) {
    throw InputError(fmt::format("discs of radius {} m do not fit into {} m × {} m", largest_radius_, size.x, size.y));
  }
  check_particle_count(count_ ? static_cast<double>(*count_)
                              : *area_ratio_ * size.x * size.y / disc_area(largest_radius_));
}

double RandomAssembly::draw_radius(RandomNumbers& random) const {
  return radii_ == Radii::uniform ? random.uniform(smallest_radius_, largest_radius_)
                                  : random.log_uniform(smallest_radius_, largest_radius_);
}

Field<double> RandomAssembly::draw_radii(double area, RandomNumbers& random) const {
  Field<double> radii = count_ ? draw_by_count(area, random) : draw_by_area(*area_ratio_ * area, random);
  std::sort(radii.begin(), radii.end(), std::greater<>());
  return radii;
}

Field<double> RandomAssembly::draw_by_count(double area, RandomNumbers& random) const {
  Field<double> radii(static_cast<std::size_t>(*count_));
  for (double& radius : radii) radius = draw_radius(random);
  const double sum = block_sum(radii.size(), [&](std::size_t i) { return disc_area(radii[i]); });
  if (sum <= largest_area_ratio * area) return radii;
  throw InputError(
      fmt::format("{} discs of {} m to {} m radius have {:.3g} times the area of the zone, and at most {} "
                  "can be packed: fewer or smaller discs would do",
                  radii.size(), smallest_radius_, largest_radius_, sum / area, largest_area_ratio));
}

Field<double> RandomAssembly::draw_by_area(double wanted, RandomNumbers& random) const {
  Field<double> radii;
  double sum = 0.0;
  for (;;) {
    const double radius = draw_radius(random);
    // The last disc is left out if the sum is nearer to what is wanted without it.
    if (!radii.empty() && sum + 0.5 * disc_area(radius) > wanted) return radii;
    radii.push_back(radius);
    check_particle_count(static_cast<double>(radii.size()));
    sum += disc_area(radius);
  }
}

std::vector<ReportEntry> RandomAssembly::report(const Packing& packing, const Rectangle& region) const {
  std::vector<ReportEntry> entries = packing_report(packing, region);
  for (ReportEntry& entry : entries) {
    if (entry.name == "n_particles" && count_) entry.target = static_cast<double>(*count_);
    if (entry.name == "smallest_radius_m") entry.target = smallest_radius_;
    if (entry.name == "largest_radius_m") entry.target = largest_radius_;
    if (entry.name == "area_ratio") entry.target = area_ratio_;
  }
  for (ReportEntry& entry : contact_report(packing, default_detection_gap())) entries.push_back(std::move(entry));
  return entries;
}

}  // namespace ligament
