#include <doctest/doctest.h>

#include "case_samples.hpp"

using namespace ligament;
using samples::error_of;
using samples::errors_in;

TEST_CASE("an unknown key names the table and the closest key") {
  CHECK(error_of([] {
          CaseFile file = CaseFile::parse(
              "[material.concrete]\nlaw = \"elastic\"\nyoung_modulus = \"20 GPa\"\n  tensile_strenght = \"3 MPa\"\n",
              "case.toml");
          for (const TableView& view : file.named_tables("material"))
            (void)samples::read<samples::Material>(file, view);
          file.throw_if_errors();
        }) == "case.toml:4:3: unknown key 'tensile_strenght' in [material.concrete]; did you mean 'tensile_strength'?");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ncolour = 1\n") ==
        "case.toml:2:1: unknown key 'colour' in [solver]");
}

TEST_CASE("wrong types") {
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = 1\n") ==
        "case.toml:2:13: 'thickness' is a bare number: expected a quantity in m (such as \"5 mm\")");
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = 1.5\n") ==
        "case.toml:2:13: 'thickness' is a bare number: expected a quantity in m (such as \"5 mm\")");
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = [\"1 m\"]\n") ==
        "case.toml:2:13: 'thickness' must be a quantity in m (such as \"5 mm\"), not a list");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\nmax_steps = \"7\"\n") ==
        "case.toml:2:13: 'max_steps' must be an integer, not a string");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\nmax_steps = 7.0\n") ==
        "case.toml:2:13: 'max_steps' must be an integer, not a number with a point or an exponent");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ntolerance = \"1e-6\"\n") ==
        "case.toml:2:13: 'tolerance' must be a number without unit, not a string");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\nverbose = 1\n") ==
        "case.toml:2:11: 'verbose' must be a boolean (true or false), not an integer");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ntolerance = 2024-01-01\n") ==
        "case.toml:2:13: 'tolerance' must be a number without unit, not a date or time");
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nx = \"1 m\"\n") ==
        "case.toml:2:5: 'x' must be a list of quantities in m, not a string");
  CHECK(errors_in<samples::Support>("s", "[s]\nfix = [\"x\"]\nat = 3\n") ==
        "case.toml:3:6: 'at' must be a table, such as at = { x = ... }, not an integer");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ntolerance = 1\n").empty());
}

TEST_CASE("wrong units") {
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = \"20 kg\"\n") ==
        "case.toml:2:13: 'thickness': '20 kg' is not a length: expected a quantity in m (such as \"5 mm\")");
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = \"20\"\n") ==
        "case.toml:2:13: 'thickness': '20' has no unit: expected a quantity in m (such as \"5 mm\")");
}

TEST_CASE("values out of range, as they were written") {
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = \"-1 mm\"\n") ==
        "case.toml:2:13: 'thickness' is -1 mm, but must be greater than 0 m");
  CHECK(errors_in<samples::Material>("m", "[m]\nlaw = \"a\"\nyoung_modulus = \"1 Pa\"\npoisson_ratio = 0.5\n") ==
        "case.toml:4:17: 'poisson_ratio' is 0.5, but must be at least 0 and less than 0.5");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\nmax_steps = 0\n") ==
        "case.toml:2:13: 'max_steps' is 0, but must be at least 1");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ntolerance = nan\n") ==
        "case.toml:2:13: 'tolerance' is nan, but must be finite");
  CHECK(errors_in<samples::Solver>("solver", "[solver]\ntolerance = inf\n") ==
        "case.toml:2:13: 'tolerance' is inf, but must be finite");
}

TEST_CASE("choices") {
  CHECK(errors_in<samples::Problem>("problem", "[problem]\nthickness = \"1 m\"\nplane = \"strss\"\n") ==
        "case.toml:3:9: 'plane' is 'strss', but must be one of 'stress', 'strain'; did you mean 'stress'?");
}

TEST_CASE("lists complain about the item concerned") {
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nx = [\"0 m\",\n  5, \"2 kg\"]\n") ==
        "case.toml:3:3: item 2 of 'x' is a bare number: expected a quantity in m (such as \"5 mm\")\n"
        "case.toml:3:6: item 3 of 'x': '2 kg' is not a length: expected a quantity in m (such as \"5 mm\")");
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nx = [\"0 m\"]\n") ==
        "case.toml:2:5: 'x' has 1 item, but must have at least 2 items");
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nnodes = [3, 0]\n") ==
        "case.toml:2:13: item 2 of 'nodes' is 0, but must be at least 1");
  CHECK(errors_in<samples::Zone>("z", "[z]\nfrom = [\"0 m\", \"0 m\"]\nto = [\"1 m\"]\n") ==
        "case.toml:3:6: 'to' has 1 item, but must have 2 items");
  CHECK(errors_in<samples::Support>("s", "[s]\nfix = [\"x\", \"z\"]\n") ==
        "case.toml:2:13: item 2 of 'fix' is 'z', but must be one of 'x', 'y'");
}

TEST_CASE("lists of numbers take whole ones, and no units") {
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nshares = [1, 0.5]\n").empty());
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nshares = [0.5, 2]\n") ==
        "case.toml:2:16: item 2 of 'shares' is 2, but must be at most 1");
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nshares = [\"1 m\"]\n") ==
        "case.toml:2:11: item 1 of 'shares' must be a number without unit, not a string");
  CHECK(errors_in<samples::Mesh>("mesh", "[mesh]\nshares = 0.5\n") ==
        "case.toml:2:10: 'shares' must be a list of numbers, not a number");
}

TEST_CASE("missing keys and tables") {
  CHECK(errors_in<samples::Material>("m", "title = 1\n[m]\nlaw = \"a\"\n")
            .find("case.toml:2:1: missing key 'young_modulus' in [m]") != std::string::npos);
  CHECK(
      errors_in<samples::Zone>("z", "[other]\n").find("case.toml: missing table [z], which must give 'from', 'to'\n") ==
      0);
}

TEST_CASE("inner tables") {
  CHECK(errors_in<samples::Support>("s", "[s]\nfix = [\"x\"]\nat = { z = \"0 m\", y = 3 }\n") ==
        "case.toml:3:8: unknown key 'z' in 'at' in [s]\n"
        "case.toml:3:23: 'y' is a bare number: expected a quantity in m (such as \"5 mm\")");
}

TEST_CASE("an absent inner table asks for nothing, a given one for what it requires") {
  struct Gauge {
    bool is_force = false;
    std::int64_t node = 0;
    void declare(Parameters& parameters) {
      parameters.table("force", is_force, "Force.").integer("node", node, "Node.").required();
    }
  };
  CHECK(errors_in<Gauge>("g", "[g]\n").empty());
  CHECK(errors_in<Gauge>("g", "[g]\nforce = {}\n") == "case.toml:2:9: missing key 'node' in 'force' in [g]");
  CaseFile file = CaseFile::parse("[g]\nforce = { node = 4 }\n[h]\n", "case.toml");
  const auto gauge = samples::read<Gauge>(file, file.table("g"));
  CHECK(gauge.is_force);
  CHECK(gauge.node == 4);
  CHECK_FALSE(samples::read<Gauge>(file, file.table("h")).is_force);
}

TEST_CASE("all errors come in one go, in the order of the file") {
  CHECK(errors_in<samples::Solver>("solver",
                                   "tilte = \"x\"\n[slover]\n[solver]\nverbose = 1\ntolerance = 0\nsteps = 3\n") ==
        "case.toml:1:1: unknown key 'tilte' at the top level\n"
        "case.toml:2:1: unknown table [slover]; did you mean 'solver'?\n"
        "case.toml:4:11: 'verbose' must be a boolean (true or false), not an integer\n"
        "case.toml:5:13: 'tolerance' is 0, but must be greater than 0\n"
        "case.toml:6:1: unknown key 'steps' in [solver]");
}

TEST_CASE("names of an array's elements") {
  const auto errors = [](const std::string& text) {
    return error_of([&] {
      CaseFile file = CaseFile::parse(text, "case.toml");
      for (const TableView& view : file.array_of_tables("zone")) file.leave_unchecked(view);
      file.throw_if_errors();
    });
  };
  CHECK(errors("[[zone]]\nname = \"a\"\n[[zone]]\nname = \"a\"\n") ==
        "case.toml:4:8: a second [[zone]] has the name 'a'");
  CHECK(errors("[[zone]]\nradius = 1\n") == "case.toml:1:1: missing key 'name' in [[zone]]");
  CHECK(errors("[[zone]]\nname = 3\n") == "case.toml:2:8: 'name' must be a string, not an integer");
  CHECK(errors("[[zone]]\nname = \"a.b\"\n") ==
        "case.toml:2:8: the name 'a.b' may hold only letters, digits, '_' and '-'");
  CHECK(errors("[zone]\nname = \"a\"\n") == "case.toml:1:1: 'zone' must be an array of tables, [[zone]], not a table");
  CHECK(errors("[[zoen]]\nname = \"a\"\n") == "case.toml:1:1: unknown table [[zoen]]; did you mean 'zone'?");
}

TEST_CASE("tables of the wrong shape") {
  CHECK(errors_in<samples::Solver>("solver", "[[solver]]\n") ==
        "case.toml:1:1: 'solver' must be a table, [solver], not an array of tables");
  CHECK(errors_in<samples::Solver>("solver", "solver = 3\n") ==
        "case.toml:1:10: 'solver' must be a table, [solver], not an integer");
  const auto named = [](const std::string& text) {
    return error_of([&] {
      CaseFile file = CaseFile::parse(text, "case.toml");
      (void)file.named_tables("material");
      file.throw_if_errors();
    });
  };
  CHECK(named("[[material]]\n") ==
        "case.toml:1:1: 'material' must hold named tables, [material.<name>], not an array of tables");
  CHECK(named("[material]\nlaw = \"a\"\n") ==
        "case.toml:2:1: 'law' must be a named table, [material.law], not a string");
  CHECK(named("[material.\"a b\"]\n") ==
        "case.toml:1:11: the name 'a b' of [material.*] may hold only letters, digits, '_' and '-'");
}
