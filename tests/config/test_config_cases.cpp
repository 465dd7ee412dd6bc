#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "../app/program.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"

using namespace ligament::test;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> cases(const std::string& prefix = "") {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(LIGAMENT_SOURCE_DIR "/config")) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() == ".toml" && name.starts_with(prefix)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  REQUIRE(!paths.empty());
  return paths;
}

/// The variants of the paper's column that come to rest: those with its eight gauges and a damped method.
std::vector<fs::path> columns_at_rest() {
  std::vector<fs::path> paths = cases("column_");
  std::erase_if(paths, [](const fs::path& path) { return path.stem() == "column_energy"; });
  REQUIRE(paths.size() == 5);
  return paths;
}

nlohmann::json summary_of(const Workplace& place) {
  return nlohmann::json::parse(content_of(place / "run/summary.json"));
}

/// What makes a case short enough for a test.
std::vector<std::string> short_form(const fs::path& path) {
  if (path.stem() != "petersson_beam_particles") return {};
  // A grading four times as coarse has a sixteenth of the particles.
  return {"--set", R"(zone.beam.sieves=["0 mm", "4 mm", "8 mm", "16 mm", "32 mm", "48 mm"])",
          "--set", R"(zone.beam.threshold_diameter="8 mm")",
          "--set", R"(zone.beam.void_diameter="8 mm")",
          "--set", R"(zone.beam.smallest_void_radius="0.76 mm")"};
}

/// Steps to take. Increments of loading are some hundred evaluations of the forces each, and sanitizers make them ten
/// times as long; cracks that run through the beam in mixed mode take minutes, after some 20 smooth increments.
int steps_of(const fs::path& path) {
  const std::string text = ligament::read_file(path);
  const bool is_in_increments = contains(text, "quasi_static") || contains(text, "secant");
#ifdef __SANITIZE_ADDRESS__
  constexpr int n_increments = 4;
#else
  constexpr int n_increments = 200;
#endif
  if (!is_in_increments) return 200;
  return path.stem().string().starts_with("arrea_beam") ? std::min(n_increments, 15) : n_increments;
}

/// The program with this case in its short form.
Finished call(const Workplace& place, const std::string& command, const fs::path& path,
              std::vector<std::string> options = {}) {
  const std::vector<std::string> shorter = short_form(path);
  options.insert(options.begin(), {command, path.string()});
  options.insert(options.end(), shorter.begin(), shorter.end());
  return place.run(options);
}

/// The names that other people's scripts read.
void check_names(const nlohmann::json& summary) {
  for (const char* name : {"version", "case", "case_hash", "ended", "steps", "wall_time_s", "threads", "n_particles",
                           "n_contacts", "n_edge_contacts", "n_elements", "n_broken", "energy_error", "audit",
                           "final_state_hash", "force_mismatch_max", "results"}) {
    CHECK_MESSAGE(summary.contains(name), std::string(name));
  }
}

}  // namespace

TEST_CASE("every case is right and takes its first 200 steps with all audits on") {
  for (const fs::path& path : cases()) {
    CAPTURE(path);
    const int n_steps = steps_of(path);
    const Workplace place;
    const Finished check = call(place, "check", path);
    CHECK(check.code == 0);
    CHECK(contains(check.out, "OK: 0 errors, 0 warnings"));
    const Finished run =
        call(place, "run", path,
             {"--output", "run", "--stop-after-steps", std::to_string(n_steps), "--set", "audit.every_step=true"});
    CHECK(run.code == 0);
    CHECK(run.err.empty());
    const auto summary = summary_of(place);
    const bool has_ended = summary.at("ended") == "converged" || summary.at("ended") == "completed";
    CHECK((summary.at("steps") == n_steps || has_ended));
    CHECK(summary.at("audit") == "passed");
    // Loading in increments has its ledger alone.
    if (!summary.contains("n_evaluations")) {
      CHECK(summary.at("motion_error").get<double>() < 1e-9);
      CHECK(summary.at("transfer_error").get<double>() < 1e-8);
    }
    check_names(summary);
  }
}

TEST_CASE("the columns converge") {
  for (const fs::path& path : columns_at_rest()) {
    CAPTURE(path);
    const Workplace place;
    const Finished run = place.run({"run", path, "--output", "run"});
    CHECK(run.code == 0);
    const auto summary = summary_of(place);
    check_names(summary);
    CHECK(summary.at("ended") == "converged");
    CHECK(summary.at("audit") == "passed");
    CHECK(summary.at("case") == path.string());
    CHECK(summary.at("n_broken") == 0);
    CHECK(summary.at("energy_error").get<double>() < 1e-8);
    CHECK(summary.at("force_mismatch_max").get<double>() < 1e-4);
    CHECK(summary.at("unbalanced_force_ratio").get<double>() <= 1e-6);
    CHECK(summary.at("steps").get<long>() <= 300);
    CHECK(summary.at("final_state_hash").get<std::string>().size() == 32);

    const ligament::CsvContent history = ligament::read_csv(place / "run/history.csv");
    CHECK(history.columns == std::vector<std::string>{"step", "time_s", "u_7_m", "u_14_m", "u_21_m", "u_28_m", "r_1_N",
                                                      "r_8_N", "r_15_N", "r_22_N", "n_broken", "unbalanced_force_ratio",
                                                      "energy_error"});
    CHECK(history.rows.front().front() == "0");
    CHECK(history.rows.back().front() == std::to_string(summary.at("steps").get<long>()));
    for (const auto& [name, value] : summary.at("results").items()) {
      CAPTURE(name);
      CHECK(history.numbers(name).back() == value.get<double>());
    }
    CHECK(summary.at("results").size() == 8);
  }
}

TEST_CASE("the columns carry their load to the support") {
  for (const fs::path& path : columns_at_rest()) {
    CAPTURE(path);
    const Workplace place;
    // Masses of two levels move contacts farther in a step, whose turn leaves a defect of second order.
    REQUIRE(place
                .run({"run", path, "--output", "small_steps", "--set", "audit.every_step=true", "--set",
                      "solver.method=dynamic_relaxation"})
                .code == 0);
    const auto small_steps = nlohmann::json::parse(content_of(place / "small_steps/summary.json"));
    CHECK(small_steps.at("energy_error").get<double>() < 1e-9);
    CHECK(small_steps.at("transfer_error").get<double>() < 1e-9);
    REQUIRE(place.run({"run", path, "--output", "run", "--set", "audit.every_step=true"}).code == 0);
    const auto summary = summary_of(place);
    CHECK(summary.at("motion_error").get<double>() < 1e-9);
    CHECK(summary.at("transfer_error").get<double>() < 1e-8);
    const auto& results = summary.at("results");
    double reaction = 0.0;
    for (const char* name : {"r_1_N", "r_8_N", "r_15_N", "r_22_N"}) reaction += results.at(name).get<double>();
    CHECK(reaction == doctest::Approx(-10000.0).epsilon(1e-5));
    for (const char* name : {"u_7_m", "u_14_m", "u_21_m", "u_28_m"}) {
      CHECK(results.at(name).get<double>() == doctest::Approx(2.4e-6).epsilon(0.01));
    }
  }
}

TEST_CASE("the column under a sudden load keeps its energy") {
  const Workplace place;
  const Finished run = place.run({"run", LIGAMENT_SOURCE_DIR "/config/column_energy.toml", "--output", "run"});
  CHECK(run.code == 0);
  const auto summary = summary_of(place);
  check_names(summary);
  CHECK(summary.at("ended") == "completed");
  CHECK(summary.at("steps") == 5000);
  CHECK(summary.at("audit") == "passed");
  CHECK(summary.at("energy_error").get<double>() < 1e-8);

  const ligament::CsvContent energy = ligament::read_csv(place / "run/energy.csv");
  CHECK(energy.rows.size() == 101);
  const auto at_end = [&](const std::string& name) { return energy.numbers(name + "_J").back(); };
  // The load does not rest: a good part of its work is motion, and nothing takes any.
  CHECK(at_end("kinetic_particles") + at_end("kinetic_nodes") > 0.0);
  CHECK(at_end("damping") == 0.0);
  CHECK(at_end("applied_loads") > 0.0);
}

TEST_CASE("the numbers of bodies of the columns are those of the paper") {
  const auto sizes = [](const std::string& name) {
    const Finished check = Workplace().run({"check", LIGAMENT_SOURCE_DIR "/config/" + name});
    return check.out;
  };
  CHECK(contains(sizes("column_fem.toml"), "0 particles, 0 contacts, 0 edge contacts, 18 elements, 28 nodes"));
  CHECK(contains(sizes("column_hexagonal_h1.toml"), "595 particles"));
  CHECK(contains(sizes("column_hexagonal_h2.toml"), "357 particles"));
  CHECK(contains(sizes("column_random_r1.toml"), "1258 particles"));
  CHECK(contains(sizes("column_random_r2.toml"), "773 particles"));
}

TEST_CASE("assemblies between walls have the elastic constants of the paper's Table 1") {
  struct Target {
    const char* name;
    double young_modulus;
    double poisson_ratio;
  };
  // Means of both directions. Those of a random assembly are met by the mean of several seeds: here is one of them.
  for (const Target& target :
       {Target{"h1", 19.93e9, 0.194}, {"h2", 20.10e9, 0.196}, {"r1", 20.05e9, 0.1875}, {"r2", 19.855e9, 0.1995}}) {
    CAPTURE(target.name);
    const Workplace place;
    const std::string path = LIGAMENT_SOURCE_DIR "/config/assembly_properties_" + std::string(target.name) + ".toml";
    REQUIRE(place.run({"run", path, "--output", "run"}).code == 0);
    const auto summary = summary_of(place);
    CHECK(summary.at("energy_error").get<double>() < 1e-8);
    const auto mean = [&](const std::string& quantity, const std::string& unit) {
      const auto& results = summary.at("results");
      return 0.5 *
             (results.at(quantity + "_x" + unit).get<double>() + results.at(quantity + "_y" + unit).get<double>());
    };
    // The region of a random assembly is a sample of it, no more than that.
    const bool is_lattice = target.name[0] == 'h';
    for (const std::string prefix : {"", "region_"}) {
      CAPTURE(prefix);
      const double tolerance = is_lattice || prefix.empty() ? 0.03 : 0.06;
      CHECK(std::abs(mean(prefix + "young_modulus", "_Pa") / target.young_modulus - 1.0) < tolerance);
      CHECK(std::abs(mean(prefix + "poisson_ratio", "") - target.poisson_ratio) < 0.015);
    }
  }
}
