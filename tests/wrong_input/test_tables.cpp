#include "rejected.hpp"

using namespace ligament::test;

TEST_CASE("unknown keys and tables, with the name that was meant") {
  check_edit("thickness = \"1 m\"", "thickness = \"1 m\"\nplain = \"stress\"", "unknown key 'plain' in [problem]",
             "plain");
  check_edit("thickness = \"1 m\"", "thickness = \"1 m\"\nplan = \"stress\"",
             "unknown key 'plan' in [problem]; did you mean 'plane'?", "plan = ");
  check_edit("radius = \"0.05 m\"", "radius = \"0.05 m\"\nseed = 1", "unknown key 'seed' in [[zone]] 'block'", "seed");
  check_edit("[solver]", "[outptu]\nevery = 1\n\n[solver]", "unknown table [outptu]; did you mean 'output'?");
  check_edit("[[load]]", "[[laod]]\nname = \"x\"\n\n[[load]]", "unknown table [[laod]]; did you mean 'load'?");
  check_edit("title = ", "author = \"me\"\ntitle = ", "unknown key 'author' at the top level");
  check_edit("at = { x = \"0 m\" }", "at = { x = \"0 m\", z = \"1 m\" }",
             "unknown key 'z' in 'at' in [[support]] 'left'", "z = \"1");
}

TEST_CASE("a key that is misspelt is missing, too: both are said, in the order of the file") {
  const std::string text = edited("young_modulus = ", "young_moduls = ");
  check_rejected(text, "case.toml:" + place_of("[material.rock]", text) +
                           ": missing key 'young_modulus' in [material.rock]\n"
                           "case.toml:" +
                           place_of("young_moduls", text) +
                           ": unknown key 'young_moduls' in [material.rock]; did you mean 'young_modulus'?");
}

TEST_CASE("all mistakes are told at once") {
  const std::string text = edited("\"0.05 m\"", "5", edited("max_steps = 100", "max_steps = -77"));
  check_rejected(text, "case.toml:" + place_of("5\nmaterial", text) +
                           ": 'radius' is a bare number: expected a quantity in m (such as \"5 mm\")\ncase.toml:" +
                           place_of("-77", text) + ": 'max_steps' is -77, but must be at least 1");
}

TEST_CASE("missing tables and keys") {
  const std::string solver = "[solver]\nmethod = \"dynamic_relaxation\"\nmax_steps = 100\n";
  check_rejected(edited(solver, ""), "case.toml: missing table [solver], which must give 'max_steps'");
  check_rejected(edited("[problem]\nthickness = \"1 m\"\n", ""),
                 "case.toml: missing table [problem], which must give 'thickness'");
  check_edit("max_steps = 100\n", "", "missing key 'max_steps' in [solver]", "[solver]");
  check_edit("name = \"block\"\n", "", "missing key 'name' in [[zone]]", "[[zone]]");
  check_rejected("title = \"nothing\"\n[problem]\nthickness = \"1 m\"\n[solver]\nmax_steps = 1\n",
                 "case.toml: there is nothing to calculate: give a [mesh], a [[zone]], or both");
}

TEST_CASE("materials") {
  check_edit("radius = \"0.05 m\"\nmaterial = \"rock\"", "radius = \"0.05 m\"\nmaterial = \"rok\"",
             "there is no material 'rok' in [[zone]] 'block' (there are: 'rock'); did you mean 'rock'?", "\"rok\"");
  check_edit("[mesh]\nmaterial = \"rock\"", "[mesh]\nmaterial = \"concrete\"",
             "there is no material 'concrete' in [mesh] (there are: 'rock')", "\"concrete\"");
  check_edit("law = \"linear_elastic\"\n", "", "missing key 'law' in [material.rock]", "[material.rock]");
}

TEST_CASE("densities where they are needed") {
  check_edit("thickness = \"1 m\"", "thickness = \"1 m\"\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]",
             "missing key 'density' in [material.rock]: gravity needs it", "[material.rock]");
  check_edit("max_steps = 100", "max_steps = 100\nmasses = \"real\"",
             "missing key 'density' in [material.rock]: masses = \"real\" needs it", "[material.rock]");
}

TEST_CASE("names that are taken or are none") {
  check_edit("name = \"corner\"", "name = \"left\" ", "a second [[support]] has the name 'left'", "\"left\" ");
  check_edit("name = \"r\"", "name = \"u\" ", "a second [[gauge]] has the name 'u'", "\"u\" ");
  check_edit("name = \"block\"", "name = \"my block\"",
             "the name 'my block' may hold only letters, digits, '_' and '-'", "\"my block\"");
  check_edit("[mesh]", "[material.rock]\nlaw = \"linear_elastic\"\n\n[mesh]",
             "syntax error: error while parsing table header: cannot redefine existing table 'material.rock'",
             "[material.rock]\nlaw = \"linear_elastic\"\n\n");
}

TEST_CASE("a table where an array of tables belongs, and the other way round") {
  check_edit("[[zone]]", "[zone]", "'zone' must be an array of tables, [[zone]], not a table");
  check_edit("[mesh]", "[[mesh]]", "'mesh' must be a table, [mesh], not an array of tables");
}

TEST_CASE("tables and keys that are given twice") {
  check_edit("[solver]", "[problem]\nthickness = \"2 m\"\n\n[solver]",
             "syntax error: error while parsing table header: cannot redefine existing table 'problem'",
             "[problem]\nthickness = \"2 m\"");
  check_edit("max_steps = 100", "max_steps = 100\nmax_steps = 200",
             "syntax error: error while parsing key-value pair: cannot redefine existing integer 'max_steps'", "200");
  const std::string wall = "[[wall]]\nname = \"floor\"\nfrom = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n";
  const std::string text = edited("[[load]]", wall + wall + "[[load]]");
  check_rejected(text, "case.toml:40:8: a second [[wall]] has the name 'floor'");
}

TEST_CASE("names that are empty or no text") {
  check_edit("name = \"block\"", "name = \"\"", "the name '' may hold only letters, digits, '_' and '-'", "\"\"");
  check_edit("name = \"block\"", "name = 5", "'name' must be a string, not an integer", "5\nfrom");
  check_edit("[mesh]",
             "[material.\"a.b\"]\nlaw = \"linear_elastic\"\nyoung_modulus = \"1 GPa\"\npoisson_ratio = 0.1\n[mesh]",
             "the name 'a.b' of [material.*] may hold only letters, digits, '_' and '-'", "\"a.b\"");
}

TEST_CASE("empty lists") {
  check_edit("x = [\"0 m\", \"1 m\", \"2 m\", \"3 m\"]", "x = []", "'x' has 0 items, but must have at least 2 items",
             "[]");
  check_edit("nodes = [4, 16]", "nodes = []",
             "no bodies in [[load]] 'tip': give 'at', 'nodes', 'particles', 'beam' or 'walls'", "[[load]]");
  check_edit("fix = [\"y\"]", "fix = []", "'fix' has 0 items, but must have at least 1 item", "[]");
  check_edit("force = [\"1 kN\", \"0 N\"]", "force = []", "'force' has 0 items, but must have 2 items", "[]");
  check_rejected("zone = []\nload = []\n[problem]\nthickness = \"1 m\"\n[solver]\nmax_steps = 1\n",
                 "case.toml: there is nothing to calculate: give a [mesh], a [[zone]], or both");
}

TEST_CASE("values where tables belong, and the other way round") {
  check_edit("[problem]\nthickness = \"1 m\"", "problem = \"thick\"",
             "'problem' must be a table, [problem], not a string", "\"thick\"");
  check_edit("[problem]\nthickness = \"1 m\"", "problem = [1]", "'problem' must be a table, [problem], not a list",
             "[1]");
  check_edit("title = ", "load = 3\ntitle = ",
             "syntax error: error while parsing table header: cannot redefine existing integer 'load' as "
             "array-of-tables",
             "[[load]]");
  check_edit("thickness = \"1 m\"", "thickness = { value = 1 }",
             "'thickness' must be a quantity in m (such as \"5 mm\"), not a table", "{ value");
  check_edit("thickness = \"1 m\"", "thickness = [\"1 m\"]",
             "'thickness' must be a quantity in m (such as \"5 mm\"), not a list", "[\"1 m\"]");
}
