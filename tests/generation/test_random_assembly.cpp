#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/text_hash.hpp"
#include "reference/all_pairs_search.hpp"
#include "support/made_generator.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

using Values = std::vector<std::pair<std::string, ParameterValue>>;

const Rectangle box{{0.0, 0.0}, {0.4, 0.3}};

Packing pack(const Values& values, std::uint64_t seed = 1, const Rectangle& region = box) {
  Values all{{"smallest_radius", 0.005}, {"largest_radius", 0.01}};
  all.insert(all.end(), values.begin(), values.end());
  return made_generator("random", all)->generate(region, seed);
}

Packing pack_count(std::int64_t count, std::uint64_t seed = 1) { return pack({{"count", count}}, seed); }

template <class Value>
std::string_view bytes_of(const Field<Value>& field) {
  return {reinterpret_cast<const char*>(field.data()), field.size() * sizeof(Value)};
}

std::string hash_of(const Packing& packing) {
  return text_hash(std::string(bytes_of(packing.position)).append(bytes_of(packing.radius)));
}

}  // namespace

TEST_CASE("golden assembly: positions and radii are the same bits on every machine") {
  CHECK(hash_of(pack_count(200)) == "d35c82cec047b41e3990543d5444c373");
  CHECK(hash_of(pack({{"area_ratio", 1.1}, {"radii", std::string("log_uniform")}})) ==
        "0a6fe2ca453ddfff007a4fefc885ea30");
}

TEST_CASE("a seed decides everything") {
  CHECK(hash_of(pack_count(300, 3)) == hash_of(pack_count(300, 3)));
  CHECK(hash_of(pack_count(300, 3)) != hash_of(pack_count(300, 4)));
}

TEST_CASE("the paper's assembly R1 comes out as dense as its counts say") {
  const auto generator =
      made_generator("random", {{"smallest_radius", 0.01}, {"largest_radius", 0.02}, {"count", std::int64_t{1258}}});
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto report = generator->generate({{1.6, 0.0}, {2.4, 1.0}}, seed).report;
    CHECK(value_of(report, "n_particles") == 1258.0);
    CHECK(value_of(report, "area_ratio") == doctest::Approx(1.16).epsilon(0.02));
    CHECK(value_of(report, "contacts_per_particle") == doctest::Approx(2.84).epsilon(0.01));
    CHECK(value_of(report, "mean_overlap") == doctest::Approx(0.115).epsilon(0.05));
    // 3570 directions at random would give 1/√3570 = 0.017.
    CHECK(value_of(report, "contact_anisotropy") < 0.03);
  }
}

TEST_CASE("the report's contacts are the pairs that the default gap bonds") {
  const auto generator =
      made_generator("random", {{"smallest_radius", 0.005}, {"largest_radius", 0.01}, {"area_ratio", 1.1}});
  const Packing packing = generator->generate(box, 5);
  CHECK(generator->default_detection_gap() == 0.0);
  CHECK(generator->default_interface_gap() == 0.0);
  const auto pairs = reference::all_particle_pairs(packing.position, packing.radius, 0.0);
  CHECK(value_of(packing.report, "n_contacts") == static_cast<double>(pairs.size()));
}

TEST_CASE("every disc keeps its centre well inside the box, and the border is lined with discs") {
  const Packing packing = pack({{"area_ratio", 1.2}}, 6, {{2.0, -1.0}, {2.4, -0.7}});
  int n_at_border = 0;
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const Vector from_low = packing.position[i] - Vector{2.0, -1.0};
    const Vector from_high = Vector{2.4, -0.7} - packing.position[i];
    const double distance = std::min({from_low.x, from_low.y, from_high.x, from_high.y});
    CHECK(distance > 0.3 * packing.radius[i]);
    if (distance <= packing.radius[i]) ++n_at_border;
  }
  // Discs of a mean diameter of 15 mm, overlapping by about a tenth, along 1.4 m.
  CHECK(n_at_border > 80);
}

TEST_CASE("radii keep to their range and distribution") {
  const double from = 0.005;
  const double to = 0.01;
  const double log_mean = (to - from) / std::log(to / from);
  for (const auto& [name, mean] : {std::pair<std::string, double>{"uniform", 0.0075}, {"log_uniform", log_mean}}) {
    const Packing packing = pack({{"count", std::int64_t{600}}, {"radii", name}}, 8);
    REQUIRE(packing.size() == 600);
    const auto [smallest, largest] = std::minmax_element(packing.radius.begin(), packing.radius.end());
    CHECK(*smallest >= from);
    CHECK(*largest < to);
    // Four standard errors; the deviation of neither is larger than that of uniform radii.
    const double error = (to - from) / std::sqrt(12.0 * 600.0);
    CHECK(std::abs(value_of(packing.report, "mean_radius_m") - mean) < 4.0 * error);
  }
}

TEST_CASE("the area ratio that is asked for comes out to within half a disc") {
  for (const double ratio : {0.9, 1.1, 1.3}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const auto report = pack({{"area_ratio", ratio}}, seed).report;
      const double half_a_disc = 0.5 * 3.1416 * 0.01 * 0.01 / (0.4 * 0.3);
      CHECK(std::abs(value_of(report, "area_ratio") - ratio) <= half_a_disc);
      CHECK(entry_of(report, "area_ratio").target == ratio);
      CHECK_FALSE(entry_of(report, "n_particles").target);
    }
  }
}

TEST_CASE("the assembly does not depend on where its zone lies") {
  const Packing here = pack_count(150);
  const Packing there = pack({{"count", std::int64_t{150}}}, 1, {{1.6, -3.0}, {2.0, -2.7}});
  REQUIRE(there.size() == here.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    const auto twin = std::find(there.radius.begin(), there.radius.end(), here.radius[i]) - there.radius.begin();
    REQUIRE(static_cast<std::size_t>(twin) < there.size());
    CHECK(norm(there.position[twin] - here.position[i] - Vector{1.6, -3.0}) < 1e-9);
  }
}

TEST_CASE("one disc alone, and discs of one size") {
  CHECK(pack_count(1).size() == 1);
  const auto report = pack({{"smallest_radius", 0.01}, {"area_ratio", 1.0}}).report;
  CHECK(value_of(report, "smallest_radius_m") == 0.01);
  CHECK(value_of(report, "largest_radius_m") == 0.01);
}

TEST_CASE("what cannot be packed is refused in words") {
  const auto message = [](const Values& values) {
    try {
      static_cast<void>(pack(values));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing is wrong");
  };
  const std::int64_t count = 100;
  CHECK(message({{"count", count}, {"smallest_radius", 0.02}}) ==
        "the smallest radius, 0.02 m, is larger than the largest, 0.01 m");
  CHECK(message({}) == "a random assembly needs either 'count' or 'area_ratio'; none is given");
  CHECK(message({{"count", count}, {"area_ratio", 1.0}}) ==
        "a random assembly needs either 'count' or 'area_ratio'; both are given");
  CHECK(message({{"count", count}, {"smallest_radius", 1e-6}, {"radii", std::string("log_uniform")}}) ==
        "log-uniform radii may differ by a factor of 1000 at most; these differ by 1e+04");
  CHECK(message({{"count", count}, {"largest_radius", 0.2}}) == "discs of radius 0.2 m do not fit into 0.4 m × 0.3 m");
  CHECK(message({{"count", std::int64_t{5000}}}) ==
        "5000 discs of 0.005 m to 0.01 m radius have 7.67 times the area of the zone, and at most 1.5 can be packed: "
        "fewer or smaller discs would do");
  CHECK(message({{"count", std::int64_t{100000000}}}) ==
        "this would make 1e+08 particles, which take some 70 GB, and the limit is 2e+07 particles: larger particles or "
        "a smaller zone would do");
}

TEST_CASE("the area ratio has a range") {
  auto generator = generators().create("random");
  Parameters parameters;
  generator->declare(parameters);
  CHECK(parameters.find("smallest_radius")->required);
  CHECK(parameters.find("largest_radius")->required);
  CHECK(parameters.find("area_ratio")->complaint(3.0) == "must be greater than 0 and at most 1.5");
  CHECK(parameters.find("area_ratio")->complaint(0.0).has_value());
  CHECK(parameters.find("count")->complaint(0.0).has_value());
}
