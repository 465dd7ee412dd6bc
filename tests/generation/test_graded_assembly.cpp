#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.hpp"
#include "core/text_hash.hpp"
#include "reference/all_pairs_search.hpp"
#include "reference/largest_empty_circle.hpp"
#include "support/made_generator.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

using Values = std::vector<std::pair<std::string, ParameterValue>>;

const Rectangle box{{0.0, 0.0}, {0.08, 0.06}};

/// The concrete of the paper's Table 3; later values replace earlier ones.
std::unique_ptr<Generator> concrete(const Values& values = {}) {
  Values all{{"sieves", std::vector<double>{0.0, 0.001, 0.002, 0.004, 0.008, 0.012}},
             {"mass_shares", std::vector<double>{0.32, 0.10, 0.14, 0.20, 0.24}},
             {"threshold_diameter", 0.002},
             {"void_diameter", 0.002},
             {"smallest_void_radius", 0.00019}};
  all.insert(all.end(), values.begin(), values.end());
  return made_generator("graded", all);
}

const Values literal{{"interpretation", std::string("literal")}, {"aggregate_content", 1879.0}};

template <class Value>
std::string_view bytes_of(const Field<Value>& field) {
  return {reinterpret_cast<const char*>(field.data()), field.size() * sizeof(Value)};
}

std::string hash_of(const Packing& packing) {
  return text_hash(std::string(bytes_of(packing.position)).append(bytes_of(packing.radius)));
}

/// Area of the discs with a diameter in [from, to) over that of the box.
double area_ratio(const Packing& packing, double from, double to) {
  double sum = 0.0;
  for (const double radius : packing.radius) {
    if (2.0 * radius >= from && 2.0 * radius < to) sum += 3.14159265358979 * radius * radius;
  }
  return sum / (box.size().x * box.size().y);
}

std::string message(const Values& values, const Rectangle& region = box) {
  try {
    static_cast<void>(concrete(values)->generate(region, 1));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

}  // namespace

TEST_CASE("golden graded assembly: positions and radii are the same bits on every machine") {
  CHECK(hash_of(concrete()->generate(box, 1)) == "94a66738f03b4605b3725a479b86fdd5");
  CHECK(hash_of(concrete(literal)->generate(box, 1)) == "c299ea716b3e9c4f68a64927a8253169");
}

TEST_CASE("a seed decides a graded assembly") {
  CHECK(hash_of(concrete()->generate(box, 3)) == hash_of(concrete()->generate(box, 3)));
  CHECK(hash_of(concrete()->generate(box, 3)) != hash_of(concrete()->generate(box, 4)));
}

TEST_CASE("classes fill the zone in proportion to their shares") {
  const Packing packing = concrete()->generate(box, 2);
  const double half_a_grain = 0.5 * 3.15 * 0.006 * 0.006 / (0.08 * 0.06);
  CHECK(std::abs(area_ratio(packing, 0.004, 0.008) - 1.1 * 0.20 / 0.58) <= half_a_grain);
  CHECK(std::abs(area_ratio(packing, 0.008, 0.012) - 1.1 * 0.24 / 0.58) <= half_a_grain);
  CHECK(value_of(packing.report, "area_ratio_4_8_mm") == doctest::Approx(area_ratio(packing, 0.004, 0.008)));
  CHECK(value_of(packing.report, "area_ratio_8_12_mm") == doctest::Approx(area_ratio(packing, 0.008, 0.012)));
  CHECK(entry_of(packing.report, "area_ratio_2_4_mm").target == doctest::Approx(1.1 * 0.14 / 0.58));
  // The finest class and the discs in the voids.
  const double n_in_voids = value_of(packing.report, "n_discs_in_voids");
  CHECK(n_in_voids > 0.0);
  CHECK(area_ratio(packing, 0.002, 0.004) ==
        doctest::Approx(value_of(packing.report, "area_ratio_2_4_mm") + n_in_voids * 3.14159265e-6 / (0.08 * 0.06)));
  CHECK(value_of(packing.report, "area_ratio") == doctest::Approx(area_ratio(packing, 0.0, 1.0)));
}

TEST_CASE("taken literally, there are the grains of the aggregate content and discs between them") {
  const Packing packing = concrete(literal)->generate(box, 2);
  const double half_a_grain = 0.5 * 3.15 * 0.006 * 0.006 / (0.08 * 0.06);
  CHECK(std::abs(area_ratio(packing, 0.004, 0.008) - 1879.0 / 2650.0 * 0.20) <= half_a_grain);
  CHECK(std::abs(area_ratio(packing, 0.008, 0.012) - 1879.0 / 2650.0 * 0.24) <= half_a_grain);
  CHECK(entry_of(packing.report, "area_ratio_2_4_mm").target == doctest::Approx(1879.0 / 2650.0 * 0.14));
  CHECK(value_of(packing.report, "area_ratio_before_voids") == doctest::Approx(1.1).epsilon(1e-3));
  const auto n_of_threshold = std::count(packing.radius.begin(), packing.radius.end(), 0.001);
  CHECK(n_of_threshold > static_cast<std::ptrdiff_t>(value_of(packing.report, "n_discs_in_voids")));
}

TEST_CASE("no void above the limit is left off the border, and the report tells the largest") {
  for (const std::uint64_t seed : {1, 2}) {
    const Packing packing = concrete()->generate(box, seed);
    constexpr double spacing = 0.0001;
    constexpr double border = 0.001 - 0.00019;
    const double on_grid =
        reference::largest_empty_circle(packing.position, packing.radius, box.size(), spacing, border);
    const double told = value_of(packing.report, "largest_void_radius_m");
    CHECK(told <= 0.00019);
    CHECK(told >= on_grid);
    CHECK(told <= on_grid + 0.71 * spacing);
  }
}

TEST_CASE("every disc of a graded assembly has its centre inside the zone, wherever that lies") {
  const Rectangle region{{1.0, -2.0}, {1.08, -1.94}};
  const Packing packing = concrete()->generate(region, 1);
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const Vector from_low = packing.position[i] - region.from;
    const Vector from_high = region.to - packing.position[i];
    CHECK(std::min({from_low.x, from_low.y, from_high.x, from_high.y}) > 0.3 * packing.radius[i]);
  }
}

TEST_CASE("the contacts told of a graded assembly are its overlapping pairs") {
  const Packing packing = concrete()->generate(box, 5);
  const auto pairs = reference::all_particle_pairs(packing.position, packing.radius, 0.0);
  CHECK(value_of(packing.report, "n_contacts") == static_cast<double>(pairs.size()));
}

TEST_CASE(
    "the paper's zones have the paper's numbers of particles, contacts and contacts with elements on both sides") {
  struct Zone {
    Vector size;
    std::vector<std::uint64_t> seeds;
    double n_particles, n_contacts, n_edge_contacts;
  };
  const std::array<Zone, 2> zones{Zone{{0.2, 0.2}, {1, 2, 3}, 3038.0, 8795.0, 121.0},
                                  Zone{{0.3, 0.306}, {1}, 6908.0, 20212.0, 195.0}};
  for (const Zone& zone : zones) {
    for (const std::uint64_t seed : zone.seeds) {
      const Packing packing = concrete()->generate({{}, zone.size}, seed);
      CHECK(value_of(packing.report, "n_particles") == doctest::Approx(zone.n_particles).epsilon(0.04));
      CHECK(value_of(packing.report, "n_contacts") == doctest::Approx(zone.n_contacts).epsilon(0.04));
      CHECK(value_of(packing.report, "contacts_per_particle") == doctest::Approx(2.895).epsilon(0.015));
      CHECK(value_of(packing.report, "contact_anisotropy") < 0.02);
      double n_at_sides = 0.0;
      for (std::size_t i = 0; i < packing.size(); ++i) {
        const double x = packing.position[i].x;
        if (std::min(x, zone.size.x - x) <= packing.radius[i]) n_at_sides += 1.0;
      }
      CHECK(n_at_sides == doctest::Approx(zone.n_edge_contacts).epsilon(0.08));
    }
  }
}

TEST_CASE("a grading that cannot be met is refused in words") {
  CHECK(message({{"mass_shares", std::vector<double>{0.32, 0.10, 0.14, 0.20, 0.20}}}) ==
        "the mass shares add up to 0.96, and should to 1");
  CHECK(message({{"mass_shares", std::vector<double>{0.5, 0.5}}}) ==
        "6 sieves have 5 classes between them, but there are 2 mass shares");
  CHECK(message({{"sieves", std::vector<double>{0.0, 0.001, 0.002, 0.008, 0.004, 0.012}}}) ==
        "the sieves must ascend, but 0.008 m comes before 0.004 m");
  CHECK(message({{"threshold_diameter", 0.003}}) ==
        "the threshold diameter, 0.003 m, must be one of the sieves: a class is taken as a whole or not at all");
  CHECK(message({{"threshold_diameter", 0.012}}) == "no grain is as large as the threshold diameter, 0.012 m");
  CHECK(message({{"mass_shares", std::vector<double>{0.5, 0.5, 0.0, 0.0, 0.0}}}) ==
        "no grain is as large as the threshold diameter, 0.002 m");
  CHECK(message({}, {{0.0, 0.0}, {0.08, 0.01}}) == "discs of diameter 0.012 m do not fit into 0.08 m × 0.01 m");
  CHECK(message({{"void_diameter", 0.1}}) == "discs of diameter 0.1 m do not fit into 0.08 m × 0.06 m");
  CHECK(message({{"void_diameter", 1e-9}}).find("the limit is 2e+07 particles") != std::string::npos);
  CHECK(message({{"interpretation", std::string("literal")}}) ==
        "interpretation = \"literal\" needs 'aggregate_content'");
  CHECK(message({{"interpretation", std::string("literal")}, {"aggregate_content", 6000.0}}) ==
        "the grains alone have 1.31 times the area of the zone, more than the area ratio of 1.1: a smaller aggregate "
        "content or a greater area ratio would do");
}
