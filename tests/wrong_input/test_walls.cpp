#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// A wall under the block of the good case, and a motion of it.
const std::string wall = "[[wall]]\nname = \"floor\"\nfrom = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n";
const std::string motion =
    "[[motion]]\nname = \"lift\"\nwalls = [\"floor\"]\ndirection = \"y\"\nvelocity = \"1 mm/s\"\n"
    "stop_time = \"10 s\"\n\n";

/// The good case with wall and motion, one text of them replaced.
void check_wall_edit(const std::string& from, const std::string& to, const std::string& message,
                     const std::string& at) {
  CAPTURE(to);
  const std::string text =
      edited(from, to, edited("[[support]]\nname = \"left\"", wall + motion + "[[support]]\nname = \"left\""));
  check_rejected(text, "case.toml:" + place_of(at, text) + ": " + message);
}

const std::string properties =
    "[problem]\nkind = \"assembly_properties\"\nthickness = \"1 m\"\n[material.rock]\nlaw = \"linear_elastic\"\n"
    "young_modulus = \"1 GPa\"\npoisson_ratio = 0.2\n[[zone]]\nname = \"a\"\nfrom = [\"0 m\", \"0 m\"]\n"
    "to = [\"1 m\", \"1 m\"]\ngenerator = \"hexagonal\"\nradius = \"0.05 m\"\nmaterial = \"rock\"\n"
    "[solver]\nmax_steps = 10\n";

}  // namespace

TEST_CASE("a wall is a segment that touches particles from outside") {
  check_wall_edit("to = [\"2 m\", \"0 m\"]", "to = [\"1 m\", \"0 m\"]", "the wall has no length in [[wall]] 'floor'",
                  "[\"1 m\", \"0 m\"]\n\n[[motion]]");
  check_wall_edit("from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n",
                  "from = [\"1 m\", \"0.5 m\"]\nto = [\"2 m\", \"0.5 m\"]\n\n",
                  "the wall runs through zone 'block' in [[wall]] 'floor': it may touch its border, no more",
                  "[\"1 m\", \"0.5 m\"]");
  check_wall_edit("from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n",
                  "from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\ncontact = \"glued\"\n\n",
                  "'contact' is 'glued', but must be one of 'frictional', 'tied'", "\"glued\"");
}

TEST_CASE("a motion of walls") {
  check_wall_edit("walls = [\"floor\"]", "walls = [\"flor\"]",
                  "there is no wall 'flor' in [[motion]] 'lift' (there are: 'floor'); did you mean 'floor'?",
                  "[\"flor\"]");
  check_wall_edit("velocity = \"1 mm/s\"\n", "", "give either 'velocity' or 'displacement' in [[motion]] 'lift'",
                  "[[motion]]");
  check_wall_edit("stop_time = \"10 s\"", "displacement = \"1 mm\"",
                  "give either 'velocity' or 'displacement' in [[motion]] 'lift'", "[[motion]]");
  check_wall_edit("velocity = \"1 mm/s\"\nstop_time = \"10 s\"", "displacement = \"1 mm\"",
                  "'displacement' needs a 'stop_time' after the 'rise_time' in [[motion]] 'lift'", "\"1 mm\"");
}

TEST_CASE("stages follow each other in equilibrium") {
  const std::string endless = "[[motion]]\nname = \"pull\"\nnodes = [4]\ndirection = \"y\"\nvelocity = \"1 mm/s\"\n\n";
  const std::string later =
      "[[motion]]\nname = \"then\"\nnodes = [16]\ndirection = \"y\"\nvelocity = \"1 mm/s\"\nstage = 2\n\n";
  check_rejected(edited("[solver]", endless + later + "[solver]"),
                 "case.toml: stage 1 never ends: one of its [[motion]] has no 'stop_time'");
  check_rejected(
      edited("method = \"dynamic_relaxation\"", "method = \"undamped\"", edited("[solver]", later + "[solver]")),
      "case.toml: stages of loading need 'unbalanced_force_ratio' in [solver]: a stage ends in equilibrium");
}

TEST_CASE("regions of gauges") {
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "stress = { from = [\"1.5 m\", \"1 m\"], to = [\"1.2 m\", \"1.5 m\"], component = \"xx\" }",
             "'to' must lie above and right of 'from' in [[gauge]] 'u'", "{ from");
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "strain = { from = [\"0 m\", \"0 m\"], to = [\"0.5 m\", \"0.5 m\"], component = \"xx\" }",
             "fewer than three particles are in the region in [[gauge]] 'u'", "{ from");
}

TEST_CASE("the test of an assembly sets its own loads") {
  const std::string gauge = "[[gauge]]\nname = \"u\"\ndisplacement = { particle = 1, direction = \"x\" }\n";
  check_rejected(properties + gauge,
                 "case.toml:" + place_of("[[gauge]]", properties + gauge) +
                     ": a case of the kind \"assembly_properties\" has no [[gauge]]: the test sets its own");
  const std::string notch = "[[notch]]\nname = \"n\"\nfrom = [\"0.5 m\", \"0 m\"]\nto = [\"0.5 m\", \"0.5 m\"]\n";
  check_rejected(properties + notch,
                 "case.toml:" + place_of("[[notch]]", properties + notch) +
                     ": a case of the kind \"assembly_properties\" has no [[notch]]: the test sets its own");
  const std::string zone =
      properties.substr(properties.find("[[zone]]"), properties.find("[solver]") - properties.find("[[zone]]"));
  std::string second = zone;
  second.replace(second.find("\"a\""), 3, "\"b\"").replace(second.find("[\"0 m\", \"0 m\"]"), 14, "[\"1 m\", \"0 m\"]");
  second.replace(second.find("to = [\"1 m\""), 11, "to = [\"2 m\"");
  check_rejected(edited("[solver]", second + "[solver]", properties),
                 "case.toml: a case of the kind \"assembly_properties\" has one [[zone]], but there are 2");
  const std::string structure =
      edited("kind = \"assembly_properties\"\n", "", properties) + "[properties]\nstrain = 1e-5\n";
  check_rejected(structure, "case.toml:" + place_of("[properties]", structure) +
                                ": [properties] is for kind = \"assembly_properties\" alone");
}
