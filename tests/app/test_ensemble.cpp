#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/csv_table.hpp"
#include "program.hpp"

using namespace ligament::test;

namespace {

const std::string specimen = LIGAMENT_SOURCE_DIR "/tests/restart/tension.toml";
const std::vector<std::string> asked{"ensemble", specimen,
                                     "--seeds",  "1:2",
                                     "--sweep",  "solver.increment=2 um,4 um",
                                     "--set",    "output.fields_every=1000",
                                     "--output", "all"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("an ensemble over seeds and values has its runs and tables and mean curves and picture" *
          doctest::test_suite("slow")) {
  const Workplace place;
  const Finished first = place.run(asked);
  CAPTURE(first.err);
  REQUIRE(first.code == 0);
  CHECK(contains(first.out, "4 of 4 runs to make, 2 at a time\n"));
  CHECK(contains(first.out, "solver.increment=2_um/seed_2: converged at step 27, energy audit passed\n"));
  for (const char c : first.out) CHECK((c == '\n' || static_cast<unsigned char>(c) >= ' '));

  const ligament::CsvContent table = ligament::read_csv(place / "all/ensemble.csv");
  CHECK(table.rows.size() == 4);
  CHECK(table.numbers("seed") == std::vector<double>{1, 2, 1, 2});
  CHECK(table.numbers("solver.increment_m") == std::vector<double>{2e-6, 2e-6, 4e-6, 4e-6});
  const std::vector<double> peaks = table.numbers("peak_load_N");
  const auto summary = nlohmann::json::parse(content_of(place / "all/solver.increment=4_um/seed_1/summary.json"));
  CHECK(peaks[2] == summary.at("peak_load_N").get<double>());

  const auto json = nlohmann::json::parse(content_of(place / "all/ensemble.json"));
  CHECK(json.at("n_done") == 4);
  const auto& peak = json.at("groups")[0].at("numbers").at("peak_load_N");
  CHECK(peak.at("mean").get<double>() == doctest::Approx(0.5 * (peaks[0] + peaks[1])));
  CHECK(peak.at("standard_deviation").get<double>() == doctest::Approx(std::abs(peaks[0] - peaks[1]) / std::sqrt(2.0)));
  CHECK(peak.at("max").get<double>() == std::max(peaks[0], peaks[1]));

  const ligament::CsvContent curve = ligament::read_csv(place / "all/solver.increment=2_um/curve.csv");
  CHECK(curve.columns == std::vector<std::string>{"extension_m", "mean_load_N", "lower_load_N", "upper_load_N",
                                                  "standard_deviation_load_N", "n_runs"});
  CHECK(curve.rows.size() == 401);
  CHECK(contains(content_of(place / "all/ensemble.svg"), "</svg>"));
  CHECK(contains(content_of(place / "all/ensemble.png"), "PNG"));

  SUBCASE("called again it makes nothing, and writes the same") {
    const std::string before = content_of(place / "all/ensemble.csv");
    const auto time = std::filesystem::last_write_time(place / "all/solver.increment=2_um/seed_1/summary.json");
    const Finished again = place.run(asked);
    CHECK(again.code == 0);
    CHECK(contains(again.out, "0 of 4 runs to make"));
    CHECK(content_of(place / "all/ensemble.csv") == before);
    CHECK(std::filesystem::last_write_time(place / "all/solver.increment=2_um/seed_1/summary.json") == time);
  }
  SUBCASE("it may grow") {
    std::vector<std::string> more = asked;
    more[3] = "1:3";
    const Finished grown = place.run(more);
    CHECK(grown.code == 0);
    CHECK(contains(grown.out, "2 of 6 runs to make"));
  }
  SUBCASE("another case is refused, and --overwrite replaces it") {
    const Finished other = place.run(with(asked, {"--set", "solver.max_steps=299"}));
    CHECK(other.code == 2);
    CHECK(other.err ==
          "all: holds an ensemble of another case: --set was output.fields_every=1000, now output.fields_every=1000, "
          "solver.max_steps=299; choose another folder with --output, or --overwrite it\n");
    const Finished over = place.run(
        {"ensemble", specimen, "--seeds", "5", "--set", "solver.increment=4 um", "--output", "all", "--overwrite"});
    CHECK(over.code == 0);
    CHECK_FALSE(std::filesystem::exists(place / "all/solver.increment=2_um"));
    CHECK(std::distance(std::filesystem::directory_iterator(place / "checkpoints"), {}) == 1);
  }
}

TEST_CASE("runs that fail are told, and the others go on") {
  const Workplace place;
  const std::vector<std::string> arguments{"ensemble", specimen,
                                           "--seeds",  "1",
                                           "--output", "all",
                                           "--sweep",  "solver.increment=4 um,5 um",
                                           "--sweep",  "audit.tolerance=1e-30,1"};
  const Finished finished = place.run(arguments);
  CHECK(finished.code == 3);
  CHECK(contains(finished.out,
                 "solver.increment=4_um/audit.tolerance=1e-30/seed_1: converged at step 14, energy audit failed "
                 "(exit code 3)\n"));
  CHECK(contains(finished.out,
                 "solver.increment=5_um/audit.tolerance=1/seed_1: converged at step 11, energy audit passed\n"));
  const auto json = nlohmann::json::parse(content_of(place / "all/ensemble.json"));
  CHECK(json.at("n_done") == 2);
  // What has come to an end of its own would only end the same again.
  const Finished again = place.run(arguments);
  CHECK(again.code == 3);
  CHECK(contains(again.out, "0 of 4 runs to make"));
}

TEST_CASE("a run that cannot even begin is told with its message") {
  const Workplace place;
  // Bonds that would snap back: known only when the assembly is made.
  const Finished finished = place.run({"ensemble", specimen, "--seeds", "1", "--output", "all", "--sweep",
                                       "material.concrete.fracture_energy_tension=1e-3 N/m,20 N/m"});
  CHECK(finished.code == 2);
  CHECK(contains(finished.out, "fracture_energy_tension=1e-3_N_m/seed_1: not_started (exit code 2)\n"));
  CHECK(contains(finished.err, "contact needs at least"));
  CHECK(contains(finished.out, "fracture_energy_tension=20_N_m/seed_1: converged"));
}
