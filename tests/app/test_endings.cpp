#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "io/csv_table.hpp"
#include "program.hpp"

using namespace ligament::test;

namespace {

const std::string column = LIGAMENT_SOURCE_DIR "/config/column_fem.toml";

nlohmann::json summary_of(const Workplace& place) {
  return nlohmann::json::parse(content_of(place / "run/summary.json"));
}

/// The column, pulled by something else than its loads.
std::string column_with(const std::string& tables) {
  const std::string text = content_of(column);
  const std::size_t begin = text.find("[[load]]");
  const std::size_t end = text.find("[[gauge]]");
  return text.substr(0, begin) + tables + text.substr(end);
}

}  // namespace

TEST_CASE("a ledger that does not close fails the run") {
  const Workplace place;
  const Finished run = place.run({"run", column, "--output", "run", "--set", "audit.tolerance=1e-30"});
  CHECK(run.code == 3);
  CHECK(contains(run.out, "energy audit failed"));
  CHECK(summary_of(place).at("audit") == "failed");
  CHECK(summary_of(place).at("ended") == "converged");
  const Finished audit = place.run({"audit", "run"});
  CHECK(audit.code == 3);
  CHECK(contains(audit.out, "tolerance 1e-30: failed"));
}

TEST_CASE("audit shows the ledger of a run, finished or not") {
  const Workplace place;
  REQUIRE(place.run({"run", column, "--output", "run"}).code == 0);
  const Finished audit = place.run({"audit", "run"});
  CHECK(audit.code == 0);
  const std::string last = ligament::read_csv(place / "run/energy.csv").rows.back().front();
  CHECK(contains(audit.out, "energy ledger at step " + last + "\n"));
  for (const char* line : {"elastic_elements_J", "applied_loads_J", "damping_J", "passed"}) {
    CHECK_MESSAGE(contains(audit.out, line), std::string(line));
  }
  std::filesystem::remove(place / "run/summary.json");
  const Finished unfinished = place.run({"audit", "run"});
  CHECK(unfinished.code == 0);
  CHECK(contains(unfinished.out, "no verdict: the run has not ended"));
  CHECK(place.run({"audit", "nowhere"}).code == 2);
  CHECK(place.run({"audit", "."}).code == 2);
}

TEST_CASE("steps that are too few to converge") {
  const Workplace place;
  const Finished run = place.run({"run", column, "--output", "run", "--set", "solver.max_steps=20"});
  CHECK(run.code == 6);
  CHECK(contains(run.out, "not_converged at step 20"));
  CHECK(summary_of(place).at("ended") == "not_converged");
  CHECK(summary_of(place).at("audit") == "passed");
  CHECK(summary_of(place).at("force_mismatch_max").is_null());
}

TEST_CASE("numbers that overflow are a divergence, not a result") {
  // No choice of the input makes the stepping unstable: masses or time step follow from the stiffness.
  const Workplace place;
  const Finished run =
      place.run({"run", column, "--output", "run", "--set", "load.right_end_corners.force=[\"1e308 N\", \"0 N\"]"});
  CHECK(run.code == 4);
  CHECK(contains(run.err, "node "));
  CHECK(contains(run.err, "has a number that is not finite"));
  CHECK(contains(run.err, "last good checkpoint: "));
  CHECK(contains(content_of(place / "run/run.log"), "has a number that is not finite"));
  const auto summary = summary_of(place);
  CHECK(summary.at("ended") == "diverged");
  CHECK(summary.at("audit") == "failed");
  CHECK(contains(summary.at("divergence").get<std::string>(), "not finite"));
}

TEST_CASE("stopping is no end") {
  const Workplace place;
  const Finished run = place.run({"run", column, "--output", "run", "--stop-after-steps", "12"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "stopped at step 12"));
  CHECK(contains(run.out, "to go on: ligament resume "));
  CHECK(summary_of(place).at("ended") == "stopped");
  // Rows stand where the case wants them, not where the run was stopped.
  CHECK(ligament::read_csv(place / "run/history.csv").rows.back().front() == "0");
  CHECK(place.run({"resume", "run", "--until-step", "13"}).code == 0);
  CHECK(summary_of(place).at("steps") == 13);
  CHECK(place.run({"resume", "run"}).code == 0);
  CHECK(summary_of(place).at("ended") == "converged");
}

TEST_CASE("a run in equilibrium while it is still being loaded has not converged") {
  const Workplace place;
  place.write("ramp.toml",
              column_with("[[load]]\nname = \"pull\"\nat = { x = \"4.8 m\" }\nforce = [\"2.5 kN\", \"0 N\"]\n"
                          "rise_time = \"5000 s\"\n\n"));
  REQUIRE(place.run({"run", "ramp.toml", "--output", "run", "--set", "solver.unbalanced_force_ratio=1e-3"}).code == 0);
  CHECK(summary_of(place).at("ended") == "converged");
  CHECK(summary_of(place).at("steps") == 5000);
  CHECK(summary_of(place).at("results").at("r_8_N").get<double>() < -3000.0);
}

TEST_CASE("a motion that stops can converge, one that goes on runs to the last step") {
  const Workplace place;
  const std::string motion =
      "[[motion]]\nname = \"pull\"\nat = { x = \"4.8 m\" }\ndirection = \"x\"\nvelocity = \"1 nm/s\"\n";
  place.write("stops.toml", column_with(motion + "stop_time = \"2400 s\"\n\n"));
  place.write("goes_on.toml", column_with(motion + "\n"));

  CHECK(place.run({"run", "stops.toml", "--output", "run"}).code == 0);
  CHECK(summary_of(place).at("ended") == "converged");
  CHECK(summary_of(place).at("results").at("u_7_m").get<double>() == doctest::Approx(2.4e-6));
  CHECK(summary_of(place).at("force_mismatch_max").get<double>() < 1e-5);

  const Finished check = place.run({"check", "goes_on.toml"});
  CHECK(contains(check.out,
                 "warning: [[motion]] 'pull' has no 'stop_time': the run cannot converge and goes on to max_steps"));
  CHECK(contains(check.out, "OK: 0 errors, 1 warnings"));
  CHECK(place.run({"run", "goes_on.toml", "--output", "run", "--overwrite", "--set", "solver.max_steps=500"}).code ==
        0);
  CHECK(summary_of(place).at("ended") == "completed");
}

TEST_CASE("bodies named twice are loaded once") {
  const Workplace place;
  const std::string load = "[[load]]\nname = \"pull\"\nforce = [\"1 kN\", \"0 N\"]\n";
  place.write("once.toml", column_with(load + "nodes = [7, 28]\n\n"));
  place.write("twice.toml", column_with(load + "nodes = [7, 28, 7]\nat = { x = \"4.8 m\", y = \"0 m\" }\n\n"));
  REQUIRE(place.run({"run", "once.toml", "--output", "run"}).code == 0);
  const auto once = summary_of(place).at("final_state_hash");
  REQUIRE(place.run({"run", "twice.toml", "--output", "run", "--overwrite"}).code == 0);
  CHECK(summary_of(place).at("final_state_hash") == once);
}
