#include "generation/contact_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/cell_grid.hpp"

namespace ligament {
namespace {

/// Sums over contacts.
struct Contacts {
  double count = 0.0;
  double overlap = 0.0;
  double largest_overlap = 0.0;
  double difference = 0.0;  ///< of n_x² and n_y²
  double product = 0.0;     ///< n_x n_y

  void add(const Vector& apart, double distance, double reach) {
    count += 1.0;
    overlap += 1.0 - distance / reach;
    largest_overlap = std::max(largest_overlap, 1.0 - distance / reach);
    if (distance == 0.0) return;
    const Vector normal = apart / distance;
    difference += normal.x * normal.x - normal.y * normal.y;
    product += normal.x * normal.y;
  }
};

Contacts find_contacts(const Packing& packing, double detection_gap) {
  Contacts contacts;
  if (packing.size() == 0) return contacts;
  const double largest_radius = *std::max_element(packing.radius.begin(), packing.radius.end());
  const CellGrid grid(packing.position, 2.0 * largest_radius * (1.0 + detection_gap));
  for (std::size_t first = 0; first < packing.size(); ++first) {
    const Vector centre = packing.position[first];
    const Vector range = uniform_vector((packing.radius[first] + largest_radius) * (1.0 + detection_gap));
    grid.visit_box(centre - range, centre + range, [&](Index second) {
      if (static_cast<std::size_t>(second) <= first) return;
      const Vector apart = packing.position[second] - centre;
      const double distance = norm(apart);
      const double reach = packing.radius[first] + packing.radius[second];
      if (distance - reach <= detection_gap * reach) contacts.add(apart, distance, reach);
    });
  }
  return contacts;
}

}  // namespace

std::vector<ReportEntry> contact_report(const Packing& packing, double detection_gap) {
  const Contacts contacts = find_contacts(packing, detection_gap);
  const double n_particles = std::max(1.0, static_cast<double>(packing.size()));
  const double n_contacts = std::max(1.0, contacts.count);
  const double anisotropy =
      std::sqrt(contacts.difference * contacts.difference + 4.0 * contacts.product * contacts.product) / n_contacts;
  return {{"n_contacts", contacts.count},
          {"contacts_per_particle", contacts.count / n_particles},
          {"mean_overlap", contacts.overlap / n_contacts},
          {"largest_overlap", contacts.largest_overlap},
          {"contact_anisotropy", anisotropy}};
}

}  // namespace ligament
