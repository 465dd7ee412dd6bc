#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// The good case with another generator, whose assemblies depend on the seed.
std::string random_case() {
  return edited("generator = \"hexagonal\"\nradius = \"0.05 m\"",
                "generator = \"random\"\nsmallest_radius = \"0.04 m\"\nlargest_radius = \"0.06 m\"\narea_ratio = 1.1");
}

/// `ensemble` of the case with these options must be refused with exactly this, and leave nothing behind.
void check_ensemble(const std::string& text, const std::vector<std::string>& options, const std::string& message) {
  CAPTURE(message);
  const Workplace place;
  place.write("case.toml", text);
  std::vector<std::string> arguments{"ensemble", "case.toml"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Finished finished = place.run(arguments);
  CHECK(finished.err == message + "\n");
  CHECK(finished.code == 2);
  CHECK(finished.out.empty());
  CHECK(place.names() == std::vector<std::string>{"case.toml"});
}

}  // namespace

TEST_CASE("an ensemble of nothing") {
  check_ensemble(random_case(), {}, "an ensemble needs --seeds, such as --seeds 1:4, or --sweep key=value,value,…");
}

TEST_CASE("seeds that are none") {
  const auto check = [](const std::string& seeds, const std::string& message) {
    check_ensemble(random_case(), {"--seeds", seeds}, message);
  };
  check("1:x", "--seeds '1:x': 'x' is no seed; expected numbers and ranges, such as 1:4 or 1:3,7");
  check("one", "--seeds 'one': 'one' is no seed; expected numbers and ranges, such as 1:4 or 1:3,7");
  check("1,,2", "--seeds '1,,2': '' is no seed; expected numbers and ranges, such as 1:4 or 1:3,7");
  check("4:1", "--seeds '4:1': 4:1 holds no number");
  check("1:20000", "an ensemble may have 10000 runs at most");
}

TEST_CASE("sweeps of what there is not") {
  const auto check = [](const std::string& sweep, const std::string& message) {
    check_ensemble(random_case(), {"--sweep", sweep}, message);
  };
  check("solver.max_step=3,4",
        "--set solver.max_step=3: unknown key 'max_step' in [solver]; did you mean 'max_steps'?");
  check("zone.blok.area_ratio=1,1.1",
        "--set zone.blok.area_ratio=1: there is no [[zone]] named 'blok' (there are: 'block'); did you mean 'block'?");
  check("solver.max_steps=3,many", "--set solver.max_steps=many: 'max_steps' must be an integer, not a string");
  check("solver.max_steps",
        "--sweep 'solver.max_steps': expected key=value,value,…, such as solver.increment=1 um,2 um");
  check("solver.max_steps=3,",
        "--sweep 'solver.max_steps=3,': expected key=value,value,…, such as solver.increment=1 um,2 um");
  check("solver.max_steps=3,3", "--sweep solver.max_steps: two values would share the folder 'solver.max_steps=3'");
}

TEST_CASE("keys that are given twice") {
  check_ensemble(random_case(), {"--seeds", "1:2", "--set", "generation.seed=3"},
                 "--seeds: 'generation.seed' is given twice");
  check_ensemble(random_case(), {"--seeds", "1:2", "--sweep", "generation.seed=3,4"},
                 "--sweep: 'generation.seed' is given twice");
}

TEST_CASE("seeds of a case without one") {
  check_ensemble(good_case(), {"--seeds", "1:2"},
                 "case.toml: no zone of the case depends on a seed, so --seeds would make the same run again");
}

TEST_CASE("a folder that holds something else") {
  const Workplace place;
  place.write("case.toml", random_case());
  place.write("taken", "a text");
  const Finished taken = place.run({"ensemble", "case.toml", "--seeds", "1", "--output", "taken"});
  CHECK(taken.code == 2);
  CHECK(taken.err == "taken: exists and is no ensemble; choose another with --output\n");
  CHECK(content_of(place / "taken") == "a text");
}
