#include "rejected.hpp"

using namespace ligament::test;

namespace {

void check_override(const std::string& override, const std::string& message) {
  CAPTURE(override);
  check_rejected(good_case(), message, {"--set", override});
}

/// Messages about the value have the override in the place of a line.
void check_value(const std::string& override, const std::string& message) {
  check_override(override, "--set " + override + ": " + message);
}

}  // namespace

TEST_CASE("--set of what there is not") {
  check_value("solver.max_step=3", "unknown key 'max_step' in [solver]; did you mean 'max_steps'?");
  check_value("solvr.max_steps=3", "unknown table [solvr]; did you mean 'solver'?");
  check_value("zone.blok.radius=\"1 mm\"",
              "there is no [[zone]] named 'blok' (there are: 'block'); did you mean 'block'?");
  check_value("material.rok.young_modulus=\"1 GPa\"",
              "there is no [material.rok] (there are: 'rock'); did you mean 'rock'?");
}

TEST_CASE("--set of keys that are none") {
  for (const std::string key : {".", "a..b", "zone.", "mesh.x[0]"}) {
    check_override(key + "=1", "--set '" + key + "=1': '" + key + "' is not a key, such as generation.seed");
  }
  check_value("nothing=1", "unknown key 'nothing' at the top level");
  check_value("solver.method.x=1", "'solver.method' is a string, which has no key 'x'");
  check_value("solver={}", "'solver' is a table: name one of its keys");
}

TEST_CASE("--set to what cannot be") {
  check_value("solver.max_steps=many", "'max_steps' must be an integer, not a string");
  check_value("zone.block.radius=1", "'radius' is a bare number: expected a quantity in m (such as \"5 mm\")");
  check_value("zone.block=1", "'zone.block' is a table: name one of its keys");
  check_value("output.every=0", "'every' is 0, but must be at least 1");
  check_value("output.every=-5", "'every' is -5, but must be at least 1");
  check_value("output.every=1.5", "'every' must be an integer, not a number with a point or an exponent");
  check_value("mesh.x=[]", "'x' has 0 items, but must have at least 2 items");
  check_value("load.tip.force=[\"1 kN\"]", "'force' has 1 item, but must have 2 items");
  check_value("problem.thickness=nan m",
              "'thickness': 'nan m' is not a finite number, one space and a unit: expected a quantity in m (such as "
              "\"5 mm\")");
  check_value("checkpoint.keep=1001", "'keep' is 1001, but must be at least 1 and at most 1000");
  check_value("output.every=-1", "'every' is -1, but must be at least 1");
  check_value("output.fields_every=0", "'fields_every' is 0, but must be at least 1");
  check_value("checkpoint.every=0", "'every' is 0, but must be at least 1");
  check_value("checkpoint.every=-1000", "'every' is -1000, but must be at least 1");
  check_value("checkpoint.keep=0", "'keep' is 0, but must be at least 1 and at most 1000");
  check_value("audit.tolerance=0", "'tolerance' is 0, but must be greater than 0");
  check_value("solver.check_every=0", "'check_every' is 0, but must be at least 1");
}

TEST_CASE("--set without a key or a value") {
  check_override("solver.max_steps", "--set 'solver.max_steps': expected key=value, such as generation.seed=3");
  check_override("=3", "--set '=3': '' is not a key, such as generation.seed");
}
