#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// A beam above the plate of the good case, clamped at its left end, and a platen under its right one.
const std::string beam =
    "[[beam]]\nname = \"steel\"\nx = [\"0.5 m\", \"2.5 m\"]\ny = [\"3 m\", \"3 m\"]\nmaterial = \"rock\"\n"
    "depth = \"0.1 m\"\nwidth = \"50 mm\"\n\n"
    "[[support]]\nname = \"clamp\"\nbeam = \"steel\"\nnodes = [1]\nfix = [\"x\", \"y\", \"rotation\"]\n\n"
    "[[wall]]\nname = \"platen\"\nfrom = [\"2 m\", \"3 m\"]\nto = [\"3 m\", \"3 m\"]\ndriven_by = \"force\"\n"
    "beam = \"steel\" # of the platen\n\n";

std::string with_beam() { return edited("[[load]]", beam + "[[load]]"); }

void check_beam_edit(const std::string& from, const std::string& to, const std::string& message,
                     const std::string& at = {}) {
  CAPTURE(to);
  const std::string text = edited(from, to, with_beam());
  check_rejected(text, "case.toml:" + place_of(at.empty() ? to : at, text) + ": " + message);
}

}  // namespace

TEST_CASE("beams") {
  check_beam_edit("[\"3 m\", \"3 m\"]\nmaterial", "[\"3 m\", \"3 m\", \"3 m\"]\nmaterial",
                  "'y' has 3 positions and 'x' has 2 in [[beam]] 'steel': every node needs both");
  check_beam_edit("x = [\"0.5 m\", \"2.5 m\"]", "x = [\"2.5 m\", \"2.5 m\"]",
                  "nodes 1 and 2 are at the same place in [[beam]] 'steel'", "[\"2.5 m\", \"2.5 m\"]");
  check_beam_edit("material = \"rock\"\ndepth", "material = \"rook\"\ndepth",
                  "there is no material 'rook' in [[beam]] 'steel' (there are: 'rock'); did you mean 'rock'?",
                  "\"rook\"");
  check_beam_edit("depth = \"0.1 m\"", "depth = \"0 m\"", "'depth' is 0 m, but must be greater than 0 m",
                  "\"0 m\"\nwidth");
  check_beam_edit("width = \"50 mm\"", "width = \"50 mm\"\ntheory = \"bernoulli\"",
                  "'theory' is 'bernoulli', but must be one of 'euler_bernoulli', 'timoshenko'", "\"bernoulli\"");
}

TEST_CASE("nodes of beams") {
  check_beam_edit("beam = \"steel\"\nnodes = [1]", "beam = \"steal\"\nnodes = [1]",
                  "there is no beam 'steal' in [[support]] 'clamp' (there are: 'steel'); did you mean 'steel'?",
                  "\"steal\"");
  check_beam_edit("beam = \"steel\"\nnodes = [1]", "beam = \"steel\"\nnodes = [3]",
                  "there is no node 3 in [[support]] 'clamp': beam 'steel' has 2", "[3]");
  check_beam_edit("beam = \"steel\"\nnodes = [1]", "beam = \"steel\"\nat = { x = \"1 m\" }",
                  "beam 'steel' has no node at this place in [[support]] 'clamp'", "{ x = \"1 m\" }");
  check_beam_edit("displacement = { node = 4, direction = \"x\" }",
                  "displacement = { beam = \"steel\", node = 4, direction = \"x\" }",
                  "'displacement' needs the number of a 'node' of beam 'steel', from 1 to 2 in [[gauge]] 'u'",
                  "{ beam");
}

TEST_CASE("platens") {
  check_beam_edit("from = [\"2 m\", \"3 m\"]", "from = [\"1 m\", \"3 m\"]",
                  "beam 'steel' has no node at the middle of the wall, (2 m, 3 m) in [[wall]] 'platen'",
                  "\"steel\" # of the platen");
  check_beam_edit("driven_by = \"force\"\n", "",
                  "a wall that rests on a beam needs driven_by = \"force\" in [[wall]] 'platen'",
                  "\"steel\" # of the platen");
  check_beam_edit("driven_by = \"force\"\nbeam = \"steel\" # of the platen", "mass = \"1 kg\"",
                  "the mass of a wall counts with driven_by = \"force\" alone in [[wall]] 'platen'", "\"1 kg\"");
  check_beam_edit(
      "driven_by = \"force\"\nbeam = \"steel\" # of the platen\n\n[[load]]\nname = \"tip\"\nnodes = [4, 16]",
      "\n[[load]]\nname = \"tip\"\nwalls = [\"platen\"]",
      "wall 'platen' is driven by motion in [[load]] 'tip': forces and supports are for walls with driven_by "
      "= \"force\"",
      "[\"platen\"]");
}

TEST_CASE("a beam that only lies on a platen may go where nothing holds it") {
  const std::string text =
      edited("nodes = [1]\nfix = [\"x\", \"y\", \"rotation\"]", "nodes = [1]\nfix = [\"y\"]", with_beam());
  check_rejected(
      text,
      "case.toml: the body of 2 nodes and 0 particles with a node at (0.5 m, 3 m) is free to move as a whole "
      "(along x): hold it by a [[support]]; free flight needs method = \"undamped\"\n"
      "case.toml: the body of 1 nodes and 0 particles with a node at (2.5 m, 3 m) is free to move as a whole "
      "(along x): hold it by a [[support]]; free flight needs method = \"undamped\"");
}
