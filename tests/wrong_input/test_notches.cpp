#include "rejected.hpp"

using namespace ligament::test;

namespace {

std::string notch(const std::string& from, const std::string& to, const std::string& more = "") {
  return "[[notch]]\nname = \"n\"\nfrom = " + from + "\nto = " + to + "\n" + more + "\n";
}

/// The good case with a notch, which must be refused with this message, placed at the first character of `at`.
void check_notch(const std::string& table, const std::string& message, const std::string& at) {
  CAPTURE(table);
  const std::string text = edited("[solver]", table + "[solver]");
  check_rejected(text, "case.toml:" + place_of(at, text) + ": " + message);
}

}  // namespace

TEST_CASE("a notch has a length and a width") {
  check_notch(notch("[\"1.5 m\", \"0.5 m\"]", "[\"1.5 m\", \"0.50 m\"]"), "the notch has no length in [[notch]] 'n'",
              "[\"1.5 m\", \"0.50 m\"]");
  check_notch(notch("[\"1.5 m\", \"0 m\"]", "[\"1.5 m\", \"0.5 m\"]", "width = \"-1 mm\"\n"),
              "'width' is -1 mm, but must be at least 0 m", "\"-1 mm\"");
}

TEST_CASE("a notch outside of everything has nothing to cut") {
  check_notch(notch("[\"1.5 m\", \"-1 m\"]", "[\"1.5 m\", \"-0.1 m\"]"),
              "the notch has nothing to cut in [[notch]] 'n'", "[[notch]]");
  check_notch(notch("[\"4 m\", \"0 m\"]", "[\"4 m\", \"2 m\"]", "width = \"10 mm\"\n"),
              "the notch has nothing to cut in [[notch]] 'n'", "[[notch]]");
}

TEST_CASE("a notch without width does not part elements") {
  const char* message =
      "a notch without width cannot part elements in [[notch]] 'n': give it a 'width', or let particles take their "
      "place";
  check_notch(notch("[\"0.5 m\", \"0 m\"]", "[\"0.5 m\", \"0.5 m\"]"), message, "[[notch]]");
  // Between elements, along a line of the mesh.
  check_notch(notch("[\"0 m\", \"1 m\"]", "[\"0.5 m\", \"1 m\"]"), message, "[[notch]]");
  check_notch(notch("[\"1 m\", \"2 m\"]", "[\"1 m\", \"3 m\"]"), message, "[[notch]]");
  check_notch(notch("[\"1.2 m\", \"1.2 m\"]", "[\"2.5 m\", \"2.9 m\"]"), message, "[[notch]]");
}

TEST_CASE("a slit takes whole elements") {
  const char* message = "the notch cuts into elements in [[notch]] 'n': its sides must follow lines of the mesh";
  check_notch(notch("[\"0.5 m\", \"0 m\"]", "[\"0.5 m\", \"1 m\"]", "width = \"0.5 m\"\n"), message, "[[notch]]");
  check_notch(notch("[\"0.5 m\", \"0 m\"]", "[\"0.5 m\", \"0.9 m\"]", "width = \"1 m\"\n"), message, "[[notch]]");
  check_notch(notch("[\"2 m\", \"2 m\"]", "[\"2.5 m\", \"2.5 m\"]", "width = \"1 cm\"\n"), message, "[[notch]]");
}
