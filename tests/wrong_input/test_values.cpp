#include "rejected.hpp"

using namespace ligament::test;

TEST_CASE("the case that all mistakes are made in is good") {
  const Workplace place;
  place.write("case.toml", good_case());
  const Finished finished = place.run({"check", "case.toml"});
  CHECK(finished.code == 0);
  CHECK(contains(finished.out, "OK: 0 errors, 0 warnings"));
  CHECK(finished.err.empty());
  CHECK(place.names() == std::vector<std::string>{"case.toml"});
}

TEST_CASE("quantities need a unit of their kind") {
  check_edit("\"20 GPa\"", "\"20 kg\"",
             "'young_modulus': '20 kg' is not a stress: expected a quantity in Pa (such as \"20 GPa\")");
  check_edit("\"20 GPa\"", "\"20 foo\"",
             "'young_modulus': '20 foo': unknown unit 'foo': expected a quantity in Pa (such as \"20 GPa\")");
  check_edit("\"20 GPa\"", "20e9", "'young_modulus' is a bare number: expected a quantity in Pa (such as \"20 GPa\")");
  check_edit("\"0.05 m\"", "0.05", "'radius' is a bare number: expected a quantity in m (such as \"5 mm\")");
  check_edit("\"0 N\"", "\"0 mm\"",
             "item 2 of 'force': '0 mm' is not a force: expected a quantity in N (such as \"1.65 kN\")");
}

TEST_CASE("values out of range") {
  check_edit("\"0.05 m\"", "\"-0.05 m\"", "'radius' is -0.05 m, but must be greater than 0 m");
  check_edit("\"1 m\"\n\n[mat", "\"0 m\"\n\n[mat", "'thickness' is 0 m, but must be greater than 0 m");
  check_edit("poisson_ratio = 0.2", "poisson_ratio = 0.5",
             "'poisson_ratio' is 0.5, but must be greater than -1 and less than 0.5", "0.5\n\n[mesh");
  check_edit("max_steps = 100", "max_steps = -100", "'max_steps' is -100, but must be at least 1", "-100");
}

TEST_CASE("numbers that are none") {
  check_edit("poisson_ratio = 0.2", "poisson_ratio = nan", "'poisson_ratio' is nan, but must be finite", "nan");
  check_edit("max_steps = 100", "max_steps = 100\nmass_safety = inf", "'mass_safety' is inf, but must be finite",
             "inf");
  check_edit(
      "\"20 GPa\"", "\"inf GPa\"",
      "'young_modulus': 'inf GPa' is not a finite number, one space and a unit: expected a quantity in Pa (such as "
      "\"20 GPa\")");
  check_edit(
      "\"20 GPa\"", "\"nan GPa\"",
      "'young_modulus': 'nan GPa' is not a finite number, one space and a unit: expected a quantity in Pa (such as "
      "\"20 GPa\")");
}

TEST_CASE("wrong types") {
  check_edit("max_steps = 100", "max_steps = 1e5",
             "'max_steps' must be an integer, not a number with a point or an exponent", "1e5");
  check_edit("max_steps = 100", "max_steps = \"100\"", "'max_steps' must be an integer, not a string", "\"100\"");
  check_edit("fix = [\"y\"]", "fix = \"y\"", "'fix' must be a list of strings, not a string", "\"y\"");
  check_edit("force = [\"1 kN\", \"0 N\"]", "force = [\"1 kN\", \"0 N\", \"0 N\"]",
             "'force' has 3 items, but must have 2 items", "[\"1 kN\"");
  check_edit("max_steps = 100", "max_steps = 2020-01-01", "'max_steps' must be an integer, not a date or time", "2020");
  check_edit("nodes = [4, 16]", "nodes = \"4\"", "'nodes' must be a list of integers, not a string", "\"4\"");
  check_edit("nodes = [4, 16]", "nodes = [4, \"16\"]", "item 2 of 'nodes' must be an integer, not a string", "\"16\"");
  check_edit("nodes = [4, 16]", "nodes = [[4], 16]", "item 1 of 'nodes' must be an integer, not a list", "[4]");
  check_edit("title = ", "title = 5 # ", "'title' must be a string, not an integer", "5 #");
  check_edit("[solver]", "[audit]\nevery_step = 1\n\n[solver]",
             "'every_step' must be a boolean (true or false), not an integer", "1\n\n[solver]");
}

TEST_CASE("names of what there is not") {
  check_edit("law = \"linear_elastic\"", "law = \"linear_elastc\"",
             "'law' is 'linear_elastc', but must be one of 'frictional', 'linear_elastic', 'mohr_coulomb_bilinear', "
             "'mohr_coulomb_brittle', 'mohr_coulomb_exponential'; did you mean 'linear_elastic'?",
             "\"linear_elastc\"");
  check_edit("\"hexagonal\"", "\"cubic\"",
             "'generator' is 'cubic', but must be one of 'file', 'graded', 'hexagonal', 'random'");
  check_edit("\"dynamic_relaxation\"", "\"implicit\"",
             "'method' is 'implicit', but must be one of 'dynamic_relaxation', 'local_damping', "
             "'two_level_relaxation', 'undamped', 'quasi_static', 'secant'");
  check_edit("node = 4, direction = \"x\"", "node = 4, direction = \"z\"",
             "'direction' is 'z', but must be one of 'x', 'y'", "\"z\"");
  check_edit("fix = [\"y\"]", "fix = [\"z\"]", "item 1 of 'fix' is 'z', but must be one of 'x', 'y', 'rotation'",
             "\"z\"");
}

TEST_CASE("bounds of relaxation that leave no room") {
  const std::string two_level = edited("\"dynamic_relaxation\"", "\"two_level_relaxation\"");
  check_rejected(edited("max_steps = 100", "max_steps = 100\nsmallest_damping = 1.5\nlargest_damping = 1.0", two_level),
                 "'smallest_damping' is 1.5 in [solver], above 'largest_damping', which is 1");
  check_rejected(edited("max_steps = 100", "max_steps = 100\ncoarse_cell = \"1 um\"", two_level),
                 "'coarse_cell' is too small: the coarse motions would have more than 100000 corners; leave it out, or "
                 "take a tenth of the structure");
}
