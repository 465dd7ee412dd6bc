#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/csv_table.hpp"
#include "program.hpp"

using namespace ligament::test;

namespace {

const std::string tension = LIGAMENT_SOURCE_DIR "/tests/restart/tension.toml";

/// The specimen of the restart tests, pulled apart, with more settings; its summary.
nlohmann::json summary_of_tension(const Workplace& place, const std::vector<std::string>& settings,
                                  const std::string& tables = {}) {
  place.write("case.toml", content_of(tension) + tables);
  std::vector<std::string> arguments{"run", "case.toml", "--output", "run", "--overwrite"};
  for (const std::string& setting : settings) {
    arguments.emplace_back("--set");
    arguments.push_back(setting);
  }
  const Finished run = place.run(arguments);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return nlohmann::json::parse(content_of(place / "run/summary.json"));
}

}  // namespace

TEST_CASE("whichever criterion is met first ends the run and is told") {
  const Workplace place;
  const std::string limits =
      "[stop]\ngauge = \"load\"\ndrop_to_share = 0.3\n[[limit]]\nname = \"far\"\ngauge = "
      "\"extension\"\nabove = 1.95e-5\n";
  const auto dropped = summary_of_tension(place, {"limit.far.above=1e-4"}, limits);
  CHECK(dropped.at("ended") == "completed");
  CHECK(dropped.at("ended_by") == "gauge 'load' has dropped to 0.3 of its peak");
  CHECK(contains(content_of(place / "run/run.log"), "(gauge 'load' has dropped to 0.3 of its peak) after"));
  const auto far = summary_of_tension(place, {"limit.far.above=7.5e-6"}, limits);
  CHECK(far.at("ended_by") == "gauge 'extension' is above 7.5e-06");
  CHECK(far.at("steps") == 8);
  CHECK(summary_of_tension(place, {}).at("ended_by").is_null());
}

TEST_CASE("a run ends when the crack has run through the specimen") {
  const Workplace place;
  const std::vector<std::string> settings{"motion.pull_apart.displacement=100 um"};
  // It is 50 mm wide.
  const auto summary = summary_of_tension(place, settings, "[stop]\ncrack_span = \"45 mm\"\n");
  CHECK(summary.at("ended") == "completed");
  CHECK(contains(summary.at("ended_by").get<std::string>(), "the macro-crack spans 0.05"));
  CHECK(std::abs(summary.at("results").at("load_N").get<double>()) < 0.05 * summary.at("peak_load_N").get<double>());
  CHECK(summary.at("steps").get<int>() < 60);
}

TEST_CASE("a run ends when a piece is cut off") {
  const Workplace place;
  // A loose grain of the brittle specimen; larger pieces stay joined by chains of grains that carry next to nothing.
  std::string text = content_of(tension);
  for (const char* energy : {"fracture_energy_tension = \"20 N/m\"\n", "fracture_energy_shear = \"500 N/m\"\n"}) {
    text.erase(text.find(energy), std::string(energy).size());
  }
  text.replace(text.find("mohr_coulomb_bilinear"), std::string("mohr_coulomb_bilinear").size(), "mohr_coulomb_brittle");
  place.write("brittle.toml", text + "[stop]\ncut_off_share = 0.001\n");
  REQUIRE(place
              .run({"run", "brittle.toml", "--output", "run", "--set", "solver.increment=3 um", "--set",
                    "motion.pull_apart.displacement=60 um"})
              .code == 0);
  const auto summary = nlohmann::json::parse(content_of(place / "run/summary.json"));
  CHECK(contains(summary.at("ended_by").get<std::string>(), " of the structure is cut off"));
  CHECK(std::stod(summary.at("ended_by").get<std::string>()) > 0.001);
  CHECK(summary.at("energy_error").get<double>() < 1e-3);
}

TEST_CASE("a specimen of the kind uniaxial has strength, Young's modulus and fracture energy") {
  const Workplace place;
  const auto results =
      summary_of_tension(place, {"problem.kind=uniaxial", "uniaxial.elongation=extension"}).at("results");
  const auto rows = ligament::read_csv(place / "run/history.csv");
  const auto load = rows.numbers("load_N");
  const auto elongation = rows.numbers("extension_m");
  const double area = 0.05 * 0.1;
  const double peak = *std::max_element(load.begin(), load.end());
  CHECK(results.at("strength_Pa").get<double>() == doctest::Approx(peak / area));
  const double stiffness = load[1] / elongation[1] * 0.1 / area;
  CHECK(results.at("young_modulus_y_Pa").get<double>() == doctest::Approx(stiffness).epsilon(0.02));
  double below = 0.0;
  for (std::size_t i = 1; i < load.size(); ++i) {
    below += 0.5 * (load[i] + load[i - 1]) * (elongation[i] - elongation[i - 1]);
  }
  CHECK(results.at("fracture_energy_N_per_m").get<double>() == doctest::Approx(below / area).epsilon(1e-12));
  const auto ledger = ligament::read_csv(place / "run/energy.csv");
  const double spent = ledger.numbers("fracture_tension_J").back() + ledger.numbers("fracture_shear_J").back() +
                       ledger.numbers("friction_J").back();
  CHECK(results.at("dissipated_energy_N_per_m").get<double>() == doctest::Approx(spent / area).epsilon(1e-12));
}

TEST_CASE("the balance of forces is told over all increments, whether the run converged or not") {
  const Workplace place;
  const auto summary = summary_of_tension(place, {}, "[stop]\ngauge = \"load\"\ndrop_to_share = 0.3\n");
  const auto rows = ligament::read_csv(place / "run/history.csv");
  const auto load = rows.numbers("load_N");
  const auto foot = rows.numbers("foot_N");
  double peak = 0.0;
  double largest = 0.0;
  for (std::size_t i = 1; i < load.size(); ++i) {
    peak = std::max(peak, std::abs(load[i]));
    largest = std::max(largest, std::abs(load[i] + foot[i]) / peak);
  }
  const auto mismatch = summary.at("force_mismatch_max").get<double>();
  CHECK(mismatch > 0.0);
  // The support at the side counts, too.
  CHECK(mismatch >= 0.99 * largest);
  CHECK(mismatch <= 1e-3);
}

TEST_CASE("a schedule does what stages do, and rows between equilibria go to a file of their own") {
  const Workplace place;
  std::string text = content_of(tension);
  const std::size_t begin = text.find("[[motion]]");
  text.replace(begin, text.find("[[gauge]]") - begin,
               "[[motion]]\nname = \"pull\"\nwalls = [\"top\"]\ndirection = \"y\"\nschedule = { time = [\"0 s\", "
               "\"1 s\", \"2 s\", \"3 s\"], displacement = [\"0 um\", \"10 um\", \"6 um\", \"46 um\"] }\n\n");
  place.write("cycle.toml", text);
  const Finished run = place.run({"run", "cycle.toml", "--output", "cycle", "--set", "output.transient_every=5"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto stages = summary_of_tension(place, {});
  CHECK_FALSE(std::filesystem::exists(place / "run/transient.csv"));
  const auto summary = nlohmann::json::parse(content_of(place / "cycle/summary.json"));
  CHECK(summary.at("n_broken") == stages.at("n_broken"));
  CHECK(summary.at("peak_load_N").get<double>() ==
        doctest::Approx(stages.at("peak_load_N").get<double>()).epsilon(1e-9));

  const auto rows = ligament::read_csv(place / "cycle/transient.csv");
  const auto step = rows.numbers("step");
  const auto evaluation = rows.numbers("evaluation");
  REQUIRE(step.size() > 20);
  CHECK(step.back() <= summary.at("steps").get<double>());
  for (std::size_t i = 0; i < step.size(); ++i) {
    CHECK(std::fmod(evaluation[i], 5.0) == 0.0);
    if (i > 0) CHECK(step[i] >= step[i - 1]);
  }
  for (const double energy : rows.numbers("kinetic_energy_J")) CHECK(energy >= 0.0);
}

TEST_CASE("gauges of places, and against supports") {
  const Workplace place;
  std::string text = content_of(LIGAMENT_SOURCE_DIR "/config/column_hexagonal_h2.toml");
  const std::string direction = ", direction = \"x\" }\n";
  const auto gauge = [&](const std::string& name, const std::string& what) {
    text += "[[gauge]]\nname = \"" + name + "\"\ndisplacement = { " + what + direction;
  };
  // Corners of the last element in the lowest row are nodes 6, 7, 14 and 13.
  gauge("n6", "node = 6");
  gauge("n13", "node = 13");
  gauge("n14", "node = 14");
  gauge("n7", "node = 7");
  gauge("inside", "point = [\"4.2 m\", \"0.0825 m\"]");
  gauge("corner", "point = [\"4.8 m\", \"0 m\"]");
  gauge("disc", "point = [\"2 m\", \"0.5 m\"]");
  gauge("against", "node = 7, relative_to = [\"left_end\"]");
  place.write("places.toml", text);
  const Finished run = place.run({"run", "places.toml", "--output", "run"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto results = nlohmann::json::parse(content_of(place / "run/summary.json")).at("results");
  const auto value = [&](const std::string& name) { return results.at(name + "_m").get<double>(); };
  const double low = 0.75 * value("n6") + 0.25 * value("n7");
  const double high = 0.75 * value("n13") + 0.25 * value("n14");
  CHECK(value("inside") == doctest::Approx(0.75 * low + 0.25 * high).epsilon(1e-9));
  CHECK(value("corner") == doctest::Approx(value("n7")).epsilon(1e-12));
  CHECK(value("disc") == doctest::Approx(1.0e-6).epsilon(0.05));
  CHECK(value("against") == value("n7"));
}
