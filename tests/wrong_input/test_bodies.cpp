#include "rejected.hpp"

using namespace ligament::test;

namespace {

const std::string beyond = ": it is beyond the last one or a zone has replaced it";

std::string unsupported(const std::string& motions) {
  return "case.toml: the body of 16 nodes and 252 particles with node 1 is free to move as a whole (" + motions +
         "): hold it by a [[support]]; free flight needs method = \"undamped\"";
}

}  // namespace

TEST_CASE("a static run needs supports against every motion") {
  check_rejected(edited("fix = [\"y\"]", "fix = [\"x\"]"), unsupported("along y"));
  check_rejected(edited("at = { x = \"0 m\" }", "nodes = [1]"), unsupported("rotation"));
}

TEST_CASE("a body that falls apart from a held one needs supports of its own") {
  const std::string loose =
      "[problem]\nthickness = \"1 m\"\n[material.rock]\nlaw = \"linear_elastic\"\nyoung_modulus = \"1 GPa\"\n"
      "poisson_ratio = 0.2\n[[zone]]\nname = \"a\"\nfrom = [\"0 m\", \"0 m\"]\nto = [\"1 m\", \"1 m\"]\n"
      "generator = \"hexagonal\"\nradius = \"0.2 m\"\nmaterial = \"rock\"\n[[zone]]\nname = \"b\"\n"
      "from = [\"0 m\", \"3 m\"]\nto = [\"1 m\", \"4 m\"]\ngenerator = \"hexagonal\"\nradius = \"0.2 m\"\n"
      "material = \"rock\"\n[[support]]\nname = \"foot\"\nparticles = [1, 1]\nfix = [\"x\", \"y\", \"rotation\"]\n"
      "[solver]\nmax_steps = 10\n";
  const Workplace place;
  place.write("case.toml", loose);
  const Finished finished = place.run({"run", "case.toml"});
  CHECK(finished.code == 2);
  CHECK(std::count(finished.err.begin(), finished.err.end(), '\n') == 1);
  CHECK(contains(finished.err, "is free to move as a whole (along x, along y, rotation)"));
  CHECK(place.names().size() == 1);
}

TEST_CASE("nodes that do not exist, or that a zone has replaced") {
  check_edit("nodes = [4, 16]", "nodes = [4, 160]", "there is no node 160 in [[load]] 'tip'" + beyond, "[4, 160]");
  // The zone spans two elements up from the bottom; a third column of nodes would lie inside a wider one.
  const std::string wide = edited("to = [\"2 m\", \"2 m\"]", "to = [\"3 m\", \"2 m\"]");
  const std::string text = edited("nodes = [4, 16]", "nodes = [3, 16]", wide);
  check_rejected(text, "case.toml:" + place_of("[3, 16]", text) + ": there is no node 3 in [[load]] 'tip'" + beyond +
                           "\ncase.toml:" + place_of("{ node = 4", text) + ": there is no node 4 in [[gauge]] 'u'" +
                           beyond);
  check_edit("nodes = [4, 16]", "particles = [100000]", "there is no particle 100000 in [[load]] 'tip'" + beyond,
             "[100000]");
  check_edit("nodes = [4, 16]", "nodes = [0]", "item 1 of 'nodes' is 0, but must be at least 1", "0]\nforce");
}

TEST_CASE("tables that select no bodies") {
  check_edit("nodes = [4, 16]\n", "", "no bodies in [[load]] 'tip': give 'at', 'nodes', 'particles', 'beam' or 'walls'",
             "[[load]]");
  check_edit(
      "nodes = [4, 16]", "at = { x = \"0.5 m\" }",
      "there is no node at this place in [[load]] 'tip': nodes are where lines of the mesh cross and no zone has "
      "replaced them",
      "{ x = \"0.5 m\"");
}

TEST_CASE("freedoms that are prescribed twice, or are none") {
  const std::string motion = "[[motion]]\nname = \"pull\"\nnodes = [1]\ndirection = \"x\"\nvelocity = \"1 um/s\"\n\n";
  const std::string twice = ": another table holds or moves it too; take it out of one of them";
  check_edit("[[load]]", motion + "[[load]]", "a freedom is prescribed twice in [[motion]] 'pull'" + twice);
  check_edit("fix = [\"y\"]", "fix = [\"y\", \"rotation\"]",
             "nodes do not rotate in [[support]] 'corner': hold 'x' or 'y' of several; 'rotation' is for particles",
             "[\"y\", \"rot");
}

TEST_CASE("gauges") {
  check_edit("displacement = { node = 4", "displacement = { node = 99", "there is no node 99 in [[gauge]] 'u'" + beyond,
             "{ node = 99");
  check_edit(
      "reaction = { node = 1", "reaction = { node = 4",
      "nothing holds or moves this body along x in [[gauge]] 'r': it has no reaction; take one of a [[support]] or "
      "[[motion]]",
      "{ node = 4, direction = \"x\" }\n\n[solver]");
  check_edit("displacement = { node = 4, direction", "displacement = { direction",
             "'displacement' needs one of 'node', 'particle', 'point', 'wall' and 'supports' in [[gauge]] 'u'",
             "{ direction");
  check_edit(
      "displacement = { node = 4, direction = \"x\" }\n", "",
      "a gauge measures one thing: give 'displacement', 'reaction', 'opening', 'stress' or 'strain' in [[gauge]] 'u'",
      "[[gauge]]");
  const std::string far =
      "opening = { from = [\"9 m\", \"0 m\"], to = [\"1.5 m\", \"1 m\"], direction = \"x\", foot = \"1 m\" }";
  check_edit("displacement = { node = 4, direction = \"x\" }", far,
             "no particle has its centre within 0.5 m of (9 m, 0 m), under the 'foot' in [[gauge]] 'u'", "{ from");
}
