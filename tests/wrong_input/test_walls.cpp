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
  check_wall_edit("velocity = \"1 mm/s\"\n", "",
                  "give one of 'velocity', 'displacement' and 'schedule' in [[motion]] 'lift'", "[[motion]]");
  check_wall_edit("stop_time = \"10 s\"", "displacement = \"1 mm\"",
                  "give one of 'velocity', 'displacement' and 'schedule' in [[motion]] 'lift'", "[[motion]]");
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

TEST_CASE("stages are numbered without gaps") {
  const auto load = [](int stage) {
    return "[[load]]\nname = \"later\"\nnodes = [16]\nforce = [\"1 kN\", \"0 N\"]\nstage = " + std::to_string(stage) +
           "\n\n";
  };
  check_edit("[solver]", load(3) + "[solver]",
             "stage 3 in [[load]] 'later' has no stage 2 before it: no [[load]] or [[motion]] has that number",
             "3\n\n[solver]");
  check_edit("[[load]]\n", "[[load]]\nstage = 2\n",
             "stage 2 in [[load]] 'tip' has no stage 1 before it: no [[load]] or [[motion]] has that number",
             "2\nname = \"tip\"");
  check_edit("[solver]", load(0) + "[solver]", "'stage' is 0, but must be at least 1 and at most 1000",
             "0\n\n[solver]");
  check_edit("[solver]", load(1001) + "[solver]", "'stage' is 1001, but must be at least 1 and at most 1000",
             "1001\n\n[solver]");
}

TEST_CASE("gravity alone may be the first stage") {
  const std::string dense = edited("poisson_ratio = 0.2", "poisson_ratio = 0.2\ndensity = \"2400 kg/m3\"");
  const std::string heavy = edited("[problem]", "[problem]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]", dense);
  const Workplace place;
  place.write("case.toml", edited("[[load]]\n", "[[load]]\nstage = 2\n", heavy));
  CHECK(place.run({"check", "case.toml"}).code == 0);
}

TEST_CASE("a wall has particles on one side") {
  const std::string zone =
      properties.substr(properties.find("[[zone]]"), properties.find("[solver]") - properties.find("[[zone]]"));
  const std::string second = edited("\"1 m\", \"1 m\"", "\"2 m\", \"1 m\"",
                                    edited("\"0 m\", \"0 m\"", "\"1 m\", \"0 m\"", edited("\"a\"", "\"b\"", zone)));
  const std::string between = "[[wall]]\nname = \"between\"\nfrom = [\"1 m\", \"0.2 m\"]\nto = [\"1 m\", \"3 m\"]\n";
  const std::string text =
      edited("kind = \"assembly_properties\"\n", "", edited("[solver]", second + between + "[solver]", properties));
  check_rejected(text,
                 "case.toml:" + place_of("[\"1 m\", \"0.2 m\"]", text) +
                     ": the wall has zone 'a' on one side and zone 'b' on the other in [[wall]] 'between': it may "
                     "touch particles on one side only");
}

TEST_CASE("walls that cannot be, or that nothing can touch") {
  check_wall_edit("from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n",
                  "from = [\"nan m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n",
                  "item 1 of 'from': 'nan m' is not a finite number, one space and a unit: expected a quantity in m "
                  "(such as \"5 mm\")",
                  "\"nan m\"");
  check_wall_edit("from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\n\n",
                  "from = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"0 m\"]\nfriction_coefficient = -1\n\n",
                  "'friction_coefficient' is -1, but must be at least 0", "-1\n");
  const std::string good = good_case();
  const std::string mesh_alone = good.substr(0, good.find("[[zone]]")) + good.substr(good.find("[[support]]"));
  const std::string text = edited(
      "[[load]]",
      edited("\"0 m\"]\nto", "\"-1 m\"]\nto", edited("[\"2 m\", \"0 m\"]", "[\"2 m\", \"-1 m\"]", wall)) + "[[load]]",
      mesh_alone);
  check_rejected(
      text, "case.toml:" + place_of("[[wall]]", text) +
                ": there are no particles, and no nodes of elements on it, for the wall to touch in [[wall]] 'floor'");
}

TEST_CASE("walls that are not there") {
  check_edit("{ node = 4, direction = \"x\" }", "{ wall = \"floor\", direction = \"x\" }",
             "there is no wall 'floor' in [[gauge]] 'u' (there are: none)", "{ wall");
  check_edit("[[load]]", motion + "[[load]]", "there is no wall 'floor' in [[motion]] 'lift' (there are: none)",
             "[\"floor\"]");
  check_edit("nodes = [1]", "walls = [\"floor\"]", "there is no wall 'floor' in [[support]] 'corner' (there are: none)",
             "[\"floor\"]");
}

TEST_CASE("regions of gauges") {
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "stress = { from = [\"1.5 m\", \"1 m\"], to = [\"1.2 m\", \"1.5 m\"], component = \"xx\" }",
             "'to' must lie above and right of 'from' in [[gauge]] 'u'", "{ from");
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "strain = { from = [\"0 m\", \"0 m\"], to = [\"0.5 m\", \"0.5 m\"], component = \"xx\" }",
             "fewer than three particles are in the region in [[gauge]] 'u'", "{ from");
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "stress = { from = [\"10 m\", \"10 m\"], to = [\"11 m\", \"11 m\"], component = \"xx\" }",
             "fewer than three particles are in the region in [[gauge]] 'u'", "{ from");
  check_edit("displacement = { node = 4, direction = \"x\" }",
             "stress = { from = [\"1 m\", \"0 m\"], to = [\"2 m\", \"1 m\"], component = \"zz\" }",
             "'component' is 'zz', but must be one of 'xx', 'yy', 'xy'", "\"zz\"");
}

TEST_CASE("how assembly properties are measured") {
  const auto check = [](const std::string& line, const std::string& message) {
    CAPTURE(line);
    const std::string text = properties + "[properties]\n" + line + "\n";
    check_rejected(text, "case.toml:18:" + std::to_string(line.find(" = ") + 4) + ": " + message);
  };
  check("strain = 0", "'strain' is 0, but must be greater than 0 and less than 0.01");
  check("strain = -1e-5", "'strain' is -1e-05, but must be greater than 0 and less than 0.01");
  check("strain = 0.01", "'strain' is 0.01, but must be greater than 0 and less than 0.01");
  check("strain = nan", "'strain' is nan, but must be finite");
  check("loading_time = \"-5 s\"", "'loading_time' is -5 s, but must be greater than 0 s");
  check("margin = 0.5", "'margin' is 0.5, but must be at least 0 and less than 0.5");
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
