#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

using namespace ligament::test;

namespace {

const std::string specimen = LIGAMENT_SOURCE_DIR "/tests/restart/tension.toml";

/// While one lives, programs are looked for in this folder alone.
class SearchPath {
 public:
  explicit SearchPath(const char* folder) : former_(std::getenv("PATH")) { ::setenv("PATH", folder, 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
  ~SearchPath() { ::setenv("PATH", former_.c_str(), 1); }

 private:
  std::string former_;
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("the report of a fractured specimen has its curves, its crack and its numbers") {
  const Workplace place;
  REQUIRE(place.run({"run", specimen, "--output", "run", "--quiet"}).code == 0);
  const Finished report = place.run({"report", "run", "--scale", "10"});
  CAPTURE(report.err);
  REQUIRE(report.code == 0);
  CHECK(contains(report.out, "report.html"));
  for (const std::string name : {"cracks", "energy", "load_N_over_extension_m", "foot_N_over_time_s"}) {
    CAPTURE(name);
    CHECK(contains(content_of(place / ("run/report/" + name + ".svg")), "</svg>"));
    CHECK(contains(content_of(place / ("run/report/" + name + ".png")), "PNG"));
  }
  const auto summary = nlohmann::json::parse(content_of(place / "run/summary.json"));
  const std::string picture = content_of(place / "run/report/cracks.svg");
  CHECK(count_of(picture, "<circle") == summary.at("n_particles").get<std::size_t>());
  CHECK(contains(picture, "broken, tension"));
  const std::string page = content_of(place / "run/report/report.html");
  CHECK(count_of(page, "<svg") == count_of(page, "</svg>"));
  CHECK(count_of(page, "<svg") >= 4);
  CHECK(contains(page, summary.at("final_state_hash").get<std::string>()));
  CHECK(contains(page, "crack.tortuosity"));
  // Self-contained: nothing is fetched from elsewhere.
  CHECK_FALSE(contains(page, "<img"));
  CHECK_FALSE(contains(page, "<link"));
  CHECK_FALSE(contains(page, "<script"));
}

TEST_CASE("a notch is drawn where it was cut, with all of the beam and with its particles alone") {
  const Workplace place;
  const std::string beam = LIGAMENT_SOURCE_DIR "/config/petersson_beam.toml";
  const Finished stopped = place.run({"run", beam, "--output", "run", "--quiet", "--stop-after-steps", "1"});
  CAPTURE(stopped.err);
  REQUIRE(stopped.code == 0);
  REQUIRE(place.run({"report", "run"}).code == 0);
  for (const std::string name : {"cracks", "cracks_close"}) {
    CHECK(contains(content_of(place / ("run/report/" + name + ".svg")), ">notch<"));
  }
  std::istringstream notch(content_of(place / "run/report/notches.dat"));
  double x = 0.0, y = 0.0, colour = 0.0;
  notch >> x >> y >> colour;
  CHECK(x == doctest::Approx(1.0));
  CHECK(y == doctest::Approx(0.0));
  notch >> x >> y >> colour;
  CHECK(x == doctest::Approx(1.0));
  CHECK(y == doctest::Approx(0.1));
}

TEST_CASE("the numbers of the crack fit the specimen") {
  const Workplace place;
  const std::string apart = R"(motion.pull_apart.displacement="150 um")";
  REQUIRE(place.run({"run", specimen, "--output", "run", "--quiet", "--set", apart}).code != 2);
  const auto crack = nlohmann::json::parse(content_of(place / "run/summary.json")).at("crack");
  // It runs across most of the width of 50 mm, and beyond it by parts of particles at most.
  const double across = crack.at("to")[0].get<double>() - crack.at("from")[0].get<double>();
  CHECK(std::abs(across) > 0.025);
  CHECK(std::abs(across) < 0.055);
  CHECK(crack.at("tortuosity").get<double>() >= 1.0);
  CHECK(crack.at("tortuosity").get<double>() < 2.0);
  CHECK(crack.at("length_m").get<double>() >= std::abs(across));
  CHECK(crack.at("damaged_width_m").get<double>() > 0.0);
  CHECK(crack.at("damaged_width_m").get<double>() < 0.1);
  CHECK(contains(content_of(place / "run/crack_path.csv"), "x_m,y_m\n"));
}

TEST_CASE("what a report lacks is named") {
  const Workplace place;
  const Finished no_run = place.run({"report", "nowhere"});
  CHECK(no_run.code == 2);
  REQUIRE(place.run({"run", specimen, "--output", "run", "--quiet", "--set", "solver.max_steps=3"}).code != 2);
  const Finished no_step = place.run({"report", "run", "--step", "2"});
  CHECK(no_step.code == 5);
  CHECK(contains(no_step.err, "there are no fields of step 2"));
  const SearchPath nothing("/nonexistent");
  const Finished no_gnuplot = place.run({"report", "run"});
  CHECK(no_gnuplot.code == 5);
  CHECK(contains(no_gnuplot.err, "gnuplot"));
  CHECK(contains(no_gnuplot.err, "install"));
}
