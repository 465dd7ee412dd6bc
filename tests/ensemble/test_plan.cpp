#include <doctest/doctest.h>

#include "core/error.hpp"
#include "ensemble/plan.hpp"
#include "ensemble/plan_file.hpp"
#include "ensemble/swept_columns.hpp"

using namespace ligament;

using Seeds = std::vector<std::int64_t>;
using Texts = std::vector<std::string>;

TEST_CASE("seeds are numbers and ranges, in order and each once") {
  CHECK(parse_seeds("1:4") == Seeds{1, 2, 3, 4});
  CHECK(parse_seeds("7") == Seeds{7});
  CHECK(parse_seeds("9,1:3,2") == Seeds{1, 2, 3, 9});
  CHECK(parse_seeds("0:0") == Seeds{0});
  for (const char* text : {"", "a", "1:", ":3", "-1", "1;2", "1:2:3", "1,", "1.5", "1 2", "99999999999999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(parse_seeds(text)), InputError);
  }
  CHECK_THROWS_WITH_AS(static_cast<void>(parse_seeds("4:1")), "--seeds '4:1': 4:1 holds no number", InputError);
  CHECK_THROWS_WITH_AS(static_cast<void>(parse_seeds("1:99999")), "an ensemble may have 10000 runs at most",
                       InputError);
}

TEST_CASE("values of a sweep are parted by commas outside of brackets and quotes") {
  CHECK(parse_sweep("solver.increment=1 um,2 um").key == "solver.increment");
  CHECK(parse_sweep("solver.increment=1 um,2 um").values == Texts{"1 um", "2 um"});
  CHECK(parse_sweep(R"(load.tip.force=["1 N", "0 N"],["2 N", "0 N"])").values ==
        Texts{R"(["1 N", "0 N"])", R"(["2 N", "0 N"])"});
  CHECK(parse_sweep(R"(title="a, b",c)").values == Texts{R"("a, b")", "c"});
  CHECK_THROWS_AS(static_cast<void>(parse_sweep("solver.increment")), InputError);
  CHECK_THROWS_AS(static_cast<void>(parse_sweep("a=1,,2")), InputError);
  CHECK_THROWS_AS(static_cast<void>(parse_sweep("a=")), InputError);
  CHECK_THROWS_AS(static_cast<void>(parse_sweep("a..b=1,2")), InputError);
}

TEST_CASE("all combinations, seeds changing fastest, in folders of their own") {
  EnsembleRequest request;
  request.seeds = {1, 2};
  request.sweeps = {{"solver.increment", {"1 um", "2 um"}}, {"solver.max_steps", {"5"}}};
  request.overrides = {"output.every=3"};
  const std::vector<EnsembleMember> members = members_of(request);
  REQUIRE(members.size() == 4);
  CHECK(members[0].run == "solver.increment=1_um/solver.max_steps=5/seed_1");
  CHECK(members[1].run == "solver.increment=1_um/solver.max_steps=5/seed_2");
  CHECK(members[2].group == "solver.increment=2_um/solver.max_steps=5");
  CHECK(members[3].overrides ==
        Texts{"output.every=3", "solver.increment=2 um", "solver.max_steps=5", "generation.seed=2"});
}

TEST_CASE("without sweep the folders are those of the seeds, without seeds every value has one run") {
  EnsembleRequest seeds;
  seeds.seeds = {3};
  CHECK(members_of(seeds).front().run == "seed_3");
  CHECK(members_of(seeds).front().group.empty());
  EnsembleRequest values;
  values.sweeps = {{"a.b", {"../x", "\"y\""}}};
  CHECK(members_of(values)[0].run == "a.b=.._x/run");
  CHECK(members_of(values)[1].run == "a.b=y/run");
  CHECK(members_of(values)[0].overrides == Texts{"a.b=../x"});
}

TEST_CASE("what would give a run twice is refused") {
  EnsembleRequest same_folder;
  same_folder.sweeps = {{"a.b", {"1 um", "1_um"}}};
  CHECK_THROWS_WITH_AS(static_cast<void>(members_of(same_folder)),
                       "--sweep a.b: two values would share the folder 'a.b=1_um'", InputError);
  EnsembleRequest twice;
  twice.sweeps = {{"a.b", {"1"}}, {"a.b", {"2"}}};
  CHECK_THROWS_WITH_AS(static_cast<void>(members_of(twice)), "--sweep: 'a.b' is given twice", InputError);
  EnsembleRequest set_too;
  set_too.seeds = {1};
  set_too.overrides = {"generation.seed=2"};
  CHECK_THROWS_WITH_AS(static_cast<void>(members_of(set_too)), "--seeds: 'generation.seed' is given twice", InputError);
}

TEST_CASE("an ensemble may grow, and differs in nothing else") {
  EnsembleRequest before;
  before.case_text = "a = 1\nb = 2\n";
  before.seeds = {1, 2};
  before.sweeps = {{"s.i", {"1"}}};
  EnsembleRequest more = before;
  more.seeds = {1, 2, 3};
  more.sweeps[0].values = {"0", "1"};
  CHECK(difference(before, more).empty());
  CHECK(difference(more, before) == "--seeds leaves out 3");
  EnsembleRequest other = before;
  other.case_text = "a = 1\nb = 3\n";
  CHECK(difference(before, other) == "line 2 of the case was 'b = 2', now 'b = 3'");
  other = before;
  other.case_text = "a = 1\n";
  CHECK(difference(before, other) == "line 2 of the case was 'b = 2', now '(end of the file)'");
  other = before;
  other.overrides = {"x.y=1"};
  CHECK(difference(before, other) == "--set was none, now x.y=1");
  other = before;
  other.sweeps[0].key = "s.j";
  CHECK(difference(before, other) == "--sweep was s.i, now s.j");
  other = before;
  other.sweeps[0].values = {"2"};
  CHECK(difference(before, other) == "--sweep s.i leaves out 1");
  other = before;
  other.seeds = {};
  CHECK(difference(before, other) == "--seeds was given before");
  CHECK(difference(other, before) == "--seeds was not given before");
}

TEST_CASE("swept quantities are numbers under a name with their unit") {
  const std::string text =
      "[solver]\nincrement = \"1e-06 m\"\nmax_steps = 5\nmethod = \"quasi_static\"\n[[load]]\nname = \"tip\"\n"
      "rise_time = \"2 s\"\nforce = [\"1 N\", \"0 N\"]\n[material.rock]\nfracture_energy = \"10 J/m2\"\n";
  const std::vector<Sweep> sweeps{{"solver.increment", {}}, {"solver.max_steps", {}},
                                  {"solver.method", {}},    {"load.tip.rise_time", {}},
                                  {"load.tip.force", {}},   {"material.rock.fracture_energy", {}}};
  EnsembleMember member;
  member.values = {"1 um", "5", "quasi_static", "2000 ms", R"(["1 N", "0 N"])", "10 N/m"};
  const std::vector<SweptValue> values = swept_values(sweeps, member, text);
  const auto check = [&](std::size_t i, const std::string& column, const std::string& cell) {
    CHECK(values[i].column == column);
    CHECK(values[i].cell == cell);
  };
  check(0, "solver.increment_m", "1e-06");
  check(1, "solver.max_steps", "5");
  check(2, "solver.method", "quasi_static");
  check(3, "load.tip.rise_time_s", "2");
  check(4, "load.tip.force", "[1 N; 0 N]");
  check(5, "material.rock.fracture_energy_J_per_m2", "10");
}
