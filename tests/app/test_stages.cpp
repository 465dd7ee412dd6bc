#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "io/csv_table.hpp"
#include "program.hpp"

using namespace ligament::test;

namespace {

/// One element, its left side held, its right side pulled in two stages.
constexpr const char* plate = R"([problem]
thickness = "1 m"
[material.rock]
law = "linear_elastic"
young_modulus = "20 GPa"
poisson_ratio = 0.0
[mesh]
material = "rock"
x = ["0 m", "1 m"]
y = ["0 m", "1 m"]
[[support]]
name = "left"
at = { x = "0 m" }
fix = ["x", "y"]
[[motion]]
name = "across"
at = { x = "1 m" }
direction = "y"
displacement = "3 um"
rise_time = "20 s"
stop_time = "100 s"
[[motion]]
name = "along"
at = { x = "1 m" }
direction = "x"
displacement = "7 um"
rise_time = "30 s"
stop_time = "80 s"
stage = 2
[[gauge]]
name = "u"
displacement = { node = 2, direction = "x" }
[[gauge]]
name = "v"
displacement = { node = 2, direction = "y" }
[solver]
max_steps = 1000
[output]
every = 1
)";

}  // namespace

TEST_CASE("motions make their whole displacement, each in its stage") {
  const Workplace place;
  place.write("case.toml", plate);
  const Finished run = place.run({"run", "case.toml", "--output", "run"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "stage 1 of 2 in equilibrium at step 100"));
  const auto results = nlohmann::json::parse(content_of(place / "run/summary.json")).at("results");
  CHECK(results.at("u_m").get<double>() == doctest::Approx(7e-6).epsilon(1e-12));
  CHECK(results.at("v_m").get<double>() == doctest::Approx(3e-6).epsilon(1e-12));

  const ligament::CsvContent history = ligament::read_csv(place / "run/history.csv");
  const std::vector<double> u = history.numbers("u_m");
  const std::vector<double> v = history.numbers("v_m");
  REQUIRE(u.size() > 181);
  // The step from 100 to 101 still has the velocity of stage 1.
  CHECK(u[101] == 0.0);
  CHECK(u[102] > 0.0);
  CHECK(v[100] == doctest::Approx(3e-6).epsilon(1e-12));
  CHECK(u[180] < 7e-6 * (1.0 - 1e-3));
  CHECK(u[181] == doctest::Approx(7e-6).epsilon(1e-12));
}
