#include <doctest/doctest.h>

#include <limits>

#include "case_samples.hpp"
#include "io/case_resolved.hpp"

using namespace ligament;

namespace {

struct Everything {
  double modulus = 1.0 / 3.0;
  std::optional<double> absent;
  double unlimited = std::numeric_limits<double>::infinity();
  double ratio = 3.0;
  std::vector<double> x;
  std::array<double, 2> from{0.1, -0.0};
  std::int64_t steps = std::numeric_limits<std::int64_t>::max();
  std::vector<std::int64_t> nodes{1, -2};
  bool on = false;
  std::string title = "a \"b\" \\ \t \xC2\xB5\n\x7F";
  std::vector<std::string> names{"p", "q"};
  std::optional<double> at_x;
  bool has_force = false;
  std::int64_t force_node = 0;

  void declare(Parameters& parameters) {
    parameters.quantity("modulus", modulus, "Pa", "");
    parameters.quantity("absent", absent, "Pa", "");
    parameters.quantity("unlimited", unlimited, "s", "");
    parameters.number("ratio", ratio, "");
    parameters.quantities("x", x, "m", "").length_at_least(1);
    parameters.point("from", from, "m", "");
    parameters.integer("steps", steps, "");
    parameters.integers("nodes", nodes, "");
    parameters.boolean("on", on, "");
    parameters.text("title", title, "");
    parameters.texts("names", names, "");
    parameters.table("at", "").quantity("x", at_x, "m", "");
    parameters.table("force", has_force, "").integer("node", force_node, "").required();
  }

  bool operator==(const Everything&) const = default;
};

std::string resolved(const std::string& text, Everything& everything, const std::vector<std::string>& overrides = {}) {
  CaseFile file = CaseFile::parse(text, "case.toml", overrides);
  everything = samples::read<Everything>(file, file.table("all"));
  file.throw_if_errors();
  return file.resolved_text();
}

}  // namespace

TEST_CASE("the resolved text reads back to the same values and to itself") {
  for (const char* text :
       {"[all]\n", "[all]\nmodulus = \"21.9 GPa\"\nx = [\"1 mm\", \"0.1 in\"]\nat = { x = \"3 um\" }\n",
        "[all]\nforce = { node = 4 }\nratio = 1e300\ntitle = \"\"\n"}) {
    CAPTURE(text);
    Everything first;
    Everything second;
    const std::string once = resolved(text, first, {"all.on=true"});
    const std::string twice = resolved(once, second);
    CHECK(once == twice);
    CHECK(first == second);
    CHECK(first.on);
  }
}

TEST_CASE("the resolved text holds defaults and overrides, with SI units") {
  Everything everything;
  CHECK(resolved("[all]\nmodulus = \"21.9 GPa\"\n", everything, {"all.ratio=2"}) ==
        "# The case as it was read: every value in SI units, defaults and overrides in.\n"
        "\n[all]\n"
        "modulus = \"2.19e+10 Pa\"\n"
        "ratio = 2.0\n"
        "from = [\"0.1 m\", \"-0 m\"]\n"
        "steps = 9223372036854775807\n"
        "nodes = [1, -2]\n"
        "on = false\n"
        "title = \"a \\\"b\\\" \\\\ \\u0009 \xC2\xB5\\u000A\\u007F\"\n"
        "names = [\"p\", \"q\"]\n");
}

TEST_CASE("tables are resolved in the order of the file, those of defaults after them") {
  CaseFile file = CaseFile::parse(
      "title = \"t\"\n[[zone]]\nname = \"b\"\nfrom = [\"0 m\", \"0 m\"]\nto = [\"1 m\", \"1 m\"]\n"
      "[material.m]\nlaw = \"a\"\nyoung_modulus = \"1 GPa\"\n[empty]\n",
      "case.toml");
  const auto solver = samples::read<samples::Solver>(file, file.table("solver"));
  CHECK(solver.max_steps == 1000);
  (void)file.table("empty");
  CHECK(file.peek(file.named_tables("material").at(0), "law") == "a");
  (void)samples::read<samples::Material>(file, file.named_tables("material").at(0));
  (void)samples::read<samples::Zone>(file, file.array_of_tables("zone").at(0));
  std::string title;
  Parameters top;
  top.text("title", title, "");
  file.read(file.top_level(), top);
  file.throw_if_errors();
  CHECK(file.resolved_text() ==
        "# The case as it was read: every value in SI units, defaults and overrides in.\n"
        "title = \"t\"\n"
        "\n[[zone]]\nname = \"b\"\nfrom = [\"0 m\", \"0 m\"]\nto = [\"1 m\", \"1 m\"]\nradius = \"0.01 m\"\n"
        "\n[material.m]\nlaw = \"a\"\nyoung_modulus = \"1e+09 Pa\"\npoisson_ratio = 0.2\n"
        "\n[empty]\n"
        "\n[solver]\ntolerance = 1e-06\nmax_steps = 1000\nverbose = false\n");
}

TEST_CASE("a fallback of a peeked key is resolved too") {
  CaseFile file = CaseFile::parse("[solver]\n", "case.toml");
  CHECK(file.peek(file.table("solver"), "method", {"explicit"}, "explicit") == "explicit");
  CHECK(file.resolved_text().find("[solver]\nmethod = \"explicit\"\n") != std::string::npos);
}
