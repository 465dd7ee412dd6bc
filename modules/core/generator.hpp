#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/rectangle.hpp"
#include "core/vector.hpp"

namespace ligament {

class Parameters;

/// A number of a packing report, with its unit in the name: {"mean_radius_m", 0.02}.
struct ReportEntry {
  std::string name;
  double value = 0.0;
  std::optional<double> target = std::nullopt;  ///< what was asked for
};

/// Discs that fill a region, and what came of it.
struct Packing {
  Field<Vector> position;  ///< centres (m)
  Field<double> radius;    ///< R (m)
  std::vector<ReportEntry> report;

  [[nodiscard]] std::size_t size() const { return radius.size(); }
};

/// Fills a region with particles.
class Generator {
 public:
  virtual ~Generator() = default;

  /// Its parameters, read from the table of the zone that names it.
  virtual void declare(Parameters& parameters) = 0;

  /// Whether another seed gives another packing.
  [[nodiscard]] virtual bool depends_on_seed() const { return true; }

  /// Throws InputError if the region cannot be filled as asked.
  [[nodiscard]] virtual Packing generate(const Rectangle& region, std::uint64_t seed) const = 0;

  /// Pairs closer than this times the sum of their radii are bonded, unless the zone says otherwise.
  [[nodiscard]] virtual double default_detection_gap() const = 0;

  /// Particles closer to a facet than this times their radius are bonded to it, unless the zone says otherwise.
  [[nodiscard]] virtual double default_interface_gap() const = 0;
};

}  // namespace ligament
