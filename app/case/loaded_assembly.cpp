#include "case/loaded_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/contact_report.hpp"
#include "generation/packing_report.hpp"
#include "generation/particle_limit.hpp"
#include "io/assembly_file.hpp"

namespace ligament {
namespace {

bool contains(const Rectangle& region, const Vector& place) {
  for (int axis = 0; axis < dimension; ++axis) {
    if (component(place, axis) < component(region.from, axis)) return false;
    if (component(place, axis) > component(region.to, axis)) return false;
  }
  return true;
}

/// What is wrong with a disc; empty if nothing is.
std::string complaint(const Vector& centre, double radius, const Rectangle& region) {
  if (!is_finite(centre) || !std::isfinite(radius)) return "has a number that is not finite";
  if (radius <= 0.0) return fmt::format("has a radius of {} m, which must be greater than 0 m", radius);
  if (!contains(region, centre)) {
    return fmt::format("has its centre at ({}, {}) m, outside of the zone", centre.x, centre.y);
  }
  if (2.0 * radius <= largest_component(region.size())) return {};
  return fmt::format("has a radius of {} m: its disc is larger than the zone", radius);
}

/// Throws InputError if two discs have the same centre: no direction leads from one to the other.
void check_centres_differ(const Packing& packing, const std::string& file) {
  const auto key = [&](std::size_t i) { return std::tie(packing.position[i].x, packing.position[i].y); };
  std::vector<std::size_t> order(packing.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  const auto twin =
      std::adjacent_find(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) == key(b); });
  if (twin == order.end()) return;
  throw InputError(fmt::format("{}: rows {} and {} have the same centre", file, *twin + 1, *std::next(twin) + 1));
}

void check_discs(const Packing& packing, const Rectangle& region, const std::string& file) {
  if (packing.size() == 0) throw InputError(fmt::format("{}: holds no discs", file));
  check_particle_count(static_cast<double>(packing.size()));
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const std::string wrong = complaint(packing.position[i], packing.radius[i], region);
    if (!wrong.empty()) throw InputError(fmt::format("{}: row {} {}", file, i + 1, wrong));
  }
  check_centres_differ(packing, file);
}

}  // namespace

void LoadedAssembly::declare(Parameters& parameters) {
  parameters
      .text("path", path_,
            "file with the particles, relative to the case file: what `ligament generate` has written (HDF5), or a "
            "table of comma-separated values with the header x_m,y_m,radius_m")
      .required();
}

Packing LoadedAssembly::generate(const Rectangle& region, std::uint64_t /*seed*/) const {
  const std::filesystem::path place = files_->location(path_);
  Packing packing = read_discs(files_->content(path_), place, zone_);
  check_discs(packing, region, place.string());
  packing.report = packing_report(packing, region);
  for (ReportEntry& entry : contact_report(packing, default_detection_gap())) {
    packing.report.push_back(std::move(entry));
  }
  return packing;
}

}  // namespace ligament
