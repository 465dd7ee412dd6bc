#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "program.hpp"
#include "version.hpp"

using namespace ligament::test;

namespace {

const std::string config = LIGAMENT_SOURCE_DIR "/config/";
const std::vector<std::string> commands{"run",      "resume", "check", "compare", "audit",  "report",
                                        "ensemble", "info",   "laws",  "explain", "schema", "reference"};

}  // namespace

TEST_CASE("version and help") {
  const Workplace place;
  const Finished version = place.run({"--version"});
  CHECK(version.code == 0);
  CHECK(contains(version.out, "ligament " + ligament::program_version() + " ("));
  const Finished help = place.run({"--help"});
  CHECK(help.code == 0);
  for (const std::string& command : commands) {
    CAPTURE(command);
    CHECK(contains(help.out, "\n  " + command + " "));
    const Finished own = place.run({command, "--help"});
    CHECK(own.code == 0);
    CHECK(contains(own.out, "Usage: ligament " + command));
    CHECK(own.err.empty());
  }
}

TEST_CASE("wrong usage says what is wrong and does nothing") {
  const Workplace place;
  const auto check = [&](const std::vector<std::string>& arguments, const std::string& message) {
    CAPTURE(message);
    const Finished finished = place.run(arguments);
    CHECK(finished.code == 2);
    CHECK(contains(finished.err, message));
    CHECK(finished.out.empty());
    CHECK(place.names().empty());
  };
  check({}, "a command is missing (there are: 'run', 'resume', ");
  check({"rum"}, "there is no command 'rum'");
  check({"rum"}, "did you mean 'run'?");
  check({"run"}, "case is required");
  check({"resume"}, "run_directory is required");
  check({"run", config + "column_fem.toml", "--fast"}, "--fast");
  check({"run", config + "column_fem.toml", config + "column_fem.toml"}, "not expected");
  check({"run", config + "column_fem.toml", "--stop-after-steps", "-1"}, "--stop-after-steps");
  check({"run", config + "column_fem.toml", "--stop-after-steps", "many"}, "--stop-after-steps");
  check({"run", config + "column_fem.toml", "--threads", "0"}, "--threads: Value 0 not in range 1 to 1024");
  check({"run", config + "column_fem.toml", "--threads", "1025"}, "--threads");
  check({"resume", "run", "--threads", "two"}, "--threads");
  check({"compare", "one"}, "b is required");
  check({"explain"}, "key is required");
}

TEST_CASE("check builds everything and writes nothing") {
  const Workplace place;
  const Finished finished = place.run({"check", config + "column_hexagonal_h1.toml"});
  CHECK(finished.code == 0);
  CHECK(contains(finished.out, "595 particles, 1686 contacts, 58 edge contacts, 15 elements, 28 nodes"));
  CHECK(contains(finished.out, "Δt = 1 s of pseudo-time"));
  CHECK(contains(finished.out, "memory: "));
  CHECK(contains(finished.out, "OK: 0 errors, 0 warnings"));
  CHECK(place.names().empty());
}

TEST_CASE("check names what limits the step of real masses, and takes overrides") {
  const Workplace place;
  const Finished finished =
      place.run({"check", config + "column_fem.toml", "--set", "solver.method=undamped", "--set", "solver.masses=real",
                 "--set", "material.continuum.density=\"2400 kg/m3\"", "--set", "problem.thickness=\"2 m\""});
  CHECK(finished.code == 0);
  CHECK(contains(finished.out, "real masses, limited by node "));
}

TEST_CASE("laws") {
  const Finished finished = Workplace().run({"laws"});
  CHECK(finished.code == 0);
  CHECK(contains(finished.out, "linear_elastic "));
  CHECK(contains(finished.out, "frictional "));
}

TEST_CASE("laws --curve draws the law of a material of a case") {
  const Workplace place;
  place.write("case.toml",
              "[problem]\nthickness = \"0.1 m\"\n[material.rock]\nlaw = \"mohr_coulomb_bilinear\"\n"
              "young_modulus = \"21.9 GPa\"\npoisson_ratio = 0.25\ntensile_strength = \"1.8 MPa\"\n"
              "cohesion = \"6.5 MPa\"\nfriction_coefficient = 0.2\nfracture_energy_tension = \"10 N/m\"\n"
              "fracture_energy_shear = \"500 N/m\"\n[solver]\nmax_steps = 1\n");
  const Finished finished = place.run({"laws", "--curve", "mohr_coulomb_bilinear", "case.toml"});
  CHECK(finished.code == 0);
  std::istringstream lines(finished.out);
  std::string line;
  std::getline(lines, line);
  CHECK(line == "curve,displacement_m,force_N");
  // Peaks below σ_t A and C A with A = 1 mm x 0.1 m, and the areas G_ft A and G_fc A, to what 200 steps can do.
  double peak[2] = {0.0, 0.0};
  double area[2] = {0.0, 0.0};
  double displacement_before = 0.0;
  double force_before = 0.0;
  while (std::getline(lines, line)) {
    const auto comma = line.find(',');
    const std::size_t curve = line.substr(0, comma) == "tension" ? 0 : 1;
    const double displacement = std::stod(line.substr(comma + 1));
    const double force = std::stod(line.substr(line.rfind(',') + 1));
    if (displacement > 0.0) area[curve] += 0.5 * (force + force_before) * (displacement - displacement_before);
    peak[curve] = std::max(peak[curve], force);
    displacement_before = displacement;
    force_before = force;
  }
  CHECK(peak[0] == doctest::Approx(180.0).epsilon(0.02));
  CHECK(peak[1] == doctest::Approx(650.0).epsilon(0.02));
  CHECK(area[0] == doctest::Approx(1e-3).epsilon(0.01));
  CHECK(area[1] == doctest::Approx(0.05).epsilon(0.01));
  CHECK(force_before == 0.0);

  const Finished other = place.run({"laws", "--curve", "frictional", "case.toml"});
  CHECK(other.code == 2);
  CHECK(other.err == "no material of the case has law = \"frictional\"\n");
  const Finished long_one = place.run({"laws", "--curve", "mohr_coulomb_bilinear", "case.toml", "--length", "0.1"});
  CHECK(long_one.code == 2);
  CHECK(contains(long_one.err, "L = 0.1 m: 'fracture_energy_tension' is 10 J/m2, but a contact needs at least 13.87"));
}

TEST_CASE("info of files of a run, and of what is none") {
  const Workplace place;
  REQUIRE(place.run({"run", config + "column_fem.toml", "--output", "run", "--stop-after-steps", "20"}).code == 0);
  const Finished fields = place.run({"info", "run/fields/elements_000000.hdf"});
  CHECK(fields.code == 0);
  CHECK(contains(fields.out, "fields (VTKHDF) at step 0, time 0 s"));

  std::string checkpoint;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(place / "checkpoints")) {
    if (contains(entry.path().string(), "000020.ckpt")) checkpoint = entry.path();
  }
  const Finished state = place.run({"info", checkpoint});
  CHECK(state.code == 0);
  CHECK(contains(state.out, "checkpoint at step 20, time 20 s"));
  CHECK(contains(state.out, "nodes.displacement"));
  for (const char* line : {"run    ", "case hash  ", "state hash  ", "written by   ligament "}) {
    CHECK(contains(state.out, line));
  }

  CHECK(place.run({"info", "nowhere"}).code == 5);
  const Finished text = place.run({"info", "run/case.toml"});
  CHECK(text.code == 5);
  CHECK(contains(text.err, "is not a ligament checkpoint"));
  std::filesystem::resize_file(checkpoint, 100);
  CHECK(place.run({"info", checkpoint}).code == 5);
}

TEST_CASE("compare") {
  const Workplace place;
  const std::string block = LIGAMENT_SOURCE_DIR "/tests/restart/falling_block.toml";
  const auto run = [&](const std::string& name, const std::string& steps) {
    REQUIRE(place.run({"run", block, "--quiet", "--output", name, "--stop-after-steps", steps}).code == 0);
  };
  run("a", "60");
  run("b", "60");
  run("later", "61");
  const Finished same = place.run({"compare", "a", "b"});
  CHECK(same.code == 0);
  CHECK(contains(same.out, "identical at step 60 (state hash "));

  const Finished later = place.run({"compare", "a", "later"});
  CHECK(later.code == 1);
  CHECK(contains(later.out, "first difference (step 60 against step 61): clock.step[0]: 60 against 61"));

  // Twice the stiffness at the same step: equal clocks would need equal steps, so the first difference is in time.
  REQUIRE(place
              .run({"run", block, "--quiet", "--output", "other", "--stop-after-steps", "60", "--set",
                    "problem.gravity=[\"0.6 m/s2\", \"-9.81 m/s2\"]"})
              .code == 0);
  const Finished other = place.run({"compare", "a", "other"});
  CHECK(other.code == 1);
  CHECK(contains(other.out, "first difference (step 60 against step 60): particles.displacement["));

  CHECK(place.run({"compare", "a", "nowhere"}).code == 2);
  CHECK(place.run({"compare", "a", "."}).code == 2);
}
