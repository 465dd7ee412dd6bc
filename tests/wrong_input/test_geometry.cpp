#include "rejected.hpp"

using namespace ligament::test;

TEST_CASE("lines of the mesh") {
  check_edit("x = [\"0 m\", \"1 m\", \"2 m\"", "x = [\"0 m\", \"2 m\", \"1 m\"", "'x' must ascend in [mesh]",
             "[\"0 m\", \"2");
  check_edit("x = [\"0 m\", \"1 m\", \"2 m\"", "x = [\"0 m\", \"1 m\", \"1 m\"", "'x' must ascend in [mesh]",
             "[\"0 m\", \"1 m\", \"1");
  check_edit("y = [\"0 m\", \"1 m\", \"2 m\", \"3 m\"]", "y = [\"0 m\"]",
             "'y' has 1 item, but must have at least 2 items", "[\"0 m\"]");
}

TEST_CASE("zones replace whole elements") {
  const std::string message =
      "the zone does not replace whole elements in [[zone]] 'block': its border must follow lines of the mesh";
  check_edit("from = [\"1 m\", \"0 m\"]", "from = [\"1.1 m\", \"0 m\"]", message, "[\"1.1 m");
  check_edit("to = [\"2 m\", \"2 m\"]", "to = [\"2 m\", \"5 m\"]", message, "[\"1 m\", \"0 m\"]\nto");
  check_edit("from = [\"1 m\", \"0 m\"]", "from = [\"2 m\", \"0 m\"]",
             "'to' must lie above and right of 'from' in [[zone]] 'block'", "[\"2 m\", \"2 m\"]");
}

TEST_CASE("zones lie apart") {
  const std::string second =
      "[[zone]]\nname = \"second\"\nfrom = [\"1 m\",\"1 m\"]\nto = [\"3 m\", \"2 m\"]\n"
      "generator = \"hexagonal\"\nradius = \"0.1 m\"\nmaterial = \"rock\"\n\n";
  check_edit("[[load]]", second + "[[load]]", "zone 'second' overlaps zone 'block': zones may share a border, no more",
             "[\"1 m\",\"1 m\"]");
}

TEST_CASE("zones hold a fair number of particles") {
  check_edit("\"0.05 m\"", "\"0.5 m\"",
             "zone 'block': a hexagonal assembly of radius 0.5 m does not fit into 1 m × 2 m", "[[zone]]");
  const std::string text = edited("\"0.05 m\"", "\"1 um\"");
  const Workplace place;
  place.write("case.toml", text);
  const Finished finished = place.run({"run", "case.toml"});
  CHECK(finished.code == 2);
  CHECK(contains(finished.err, "case.toml:" + place_of("[[zone]]", text) + ": zone 'block': this would make "));
  CHECK(contains(finished.err, "larger particles or a smaller zone would do"));
  CHECK(place.names().size() == 1);
}

TEST_CASE("the hexagonal stiffness has a limit of Poisson's ratio") {
  check_edit("poisson_ratio = 0.2", "poisson_ratio = 0.35\nstiffness = \"hexagonal\"",
             "stiffness = \"hexagonal\" needs 'poisson_ratio' below 0.3333, but it is 0.35 in [material.rock] (used in "
             "[[zone]] 'block'); take stiffness = \"plane\"",
             "0.35");
  const std::string strain = edited("thickness = \"1 m\"", "thickness = \"1 m\"\nplane = \"strain\"");
  const std::string text = edited("poisson_ratio = 0.2", "poisson_ratio = 0.3\nstiffness = \"hexagonal\"", strain);
  check_rejected(text, "case.toml:" + place_of("0.3\n", text) +
                           ": stiffness = \"hexagonal\" needs 'poisson_ratio' below 0.25, but it is 0.3 in "
                           "[material.rock] (used in [[zone]] 'block'); take stiffness = \"plane\"");
}
