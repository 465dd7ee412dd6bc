#include <doctest/doctest.h>

#include <cmath>

#include "generation/contact_report.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/made_generator.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

std::vector<ReportEntry> report(const Field<Vector>& centres, double radius, double gap = 0.0) {
  return contact_report({centres, Field<double>(centres.size(), radius), {}}, gap);
}

}  // namespace

TEST_CASE("three discs in a triangle: three contacts, one a disc, no direction preferred") {
  const double side = 0.18;  // overlaps by a tenth of the sum of the radii
  const auto triangle = report({{0.0, 0.0}, {side, 0.0}, {0.5 * side, std::sqrt(0.75) * side}}, 0.1);
  CHECK(value_of(triangle, "n_contacts") == 3.0);
  CHECK(value_of(triangle, "contacts_per_particle") == 1.0);
  CHECK(value_of(triangle, "mean_overlap") == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(value_of(triangle, "largest_overlap") == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(value_of(triangle, "contact_anisotropy") < 1e-12);
}

TEST_CASE("a row of discs prefers one direction, whichever it is") {
  for (const Vector direction : {Vector{1.0, 0.0}, {0.0, 1.0}, {0.6, -0.8}}) {
    const auto row = report({0.0 * direction, 0.18 * direction, 0.34 * direction}, 0.1);
    CHECK(value_of(row, "n_contacts") == 2.0);
    CHECK(value_of(row, "mean_overlap") == doctest::Approx(0.15).epsilon(1e-12));
    CHECK(value_of(row, "largest_overlap") == doctest::Approx(0.2).epsilon(1e-12));
    CHECK(value_of(row, "contact_anisotropy") == doctest::Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("two contacts along x and one along y: a third more in one direction than across it") {
  const auto corner = report({{0.0, 0.0}, {0.18, 0.0}, {0.36, 0.0}, {0.0, 0.18}}, 0.1);
  CHECK(value_of(corner, "n_contacts") == 3.0);
  CHECK(value_of(corner, "contact_anisotropy") == doctest::Approx(1.0 / 3.0).epsilon(1e-12));
}

TEST_CASE("the detection gap decides what a contact is") {
  const Field<Vector> pair{{0.0, 0.0}, {0.204, 0.0}};
  CHECK(value_of(report(pair, 0.1, 0.019), "n_contacts") == 0.0);
  const auto near = report(pair, 0.1, 0.021);
  CHECK(value_of(near, "n_contacts") == 1.0);
  CHECK(value_of(near, "mean_overlap") == doctest::Approx(-0.02).epsilon(1e-12));
}

TEST_CASE("contacts are those that a look at all pairs finds") {
  RandomNumbers random(31);
  Packing packing;
  for (int i = 0; i < 400; ++i) {
    packing.position.push_back(random.vector(1.0));
    packing.radius.push_back(random.uniform(0.002, 0.1));
  }
  const auto pairs = reference::all_particle_pairs(packing.position, packing.radius, 0.0);
  double overlap = 0.0;
  for (const SetupPair& pair : pairs) {
    const double reach = packing.radius[pair.first] + packing.radius[pair.second];
    overlap += 1.0 - norm(packing.position[pair.second] - packing.position[pair.first]) / reach;
  }
  const auto entries = contact_report(packing, 0.0);
  CHECK(value_of(entries, "n_contacts") == static_cast<double>(pairs.size()));
  CHECK(value_of(entries, "mean_overlap") == doctest::Approx(overlap / static_cast<double>(pairs.size())));
}

TEST_CASE("discs that do not touch, and no discs, have no contacts") {
  for (const auto& centres : {Field<Vector>{{0.0, 0.0}, {1.0, 0.0}}, Field<Vector>{}}) {
    for (const ReportEntry& entry : report(centres, 0.1)) CHECK(entry.value == 0.0);
  }
}
