#include <doctest/doctest.h>

#include "case_samples.hpp"
#include "io/case_overrides.hpp"

using namespace ligament;
using samples::error_of;
using samples::errors_in;

namespace {

const char* const zones_text =
    "[[zone]]\nname = \"left\"\nfrom = [\"0 m\", \"0 m\"]\nto = [\"1 m\", \"1 m\"]\n"
    "[[zone]]\nname = \"middle\"\nfrom = [\"1 m\", \"0 m\"]\nto = [\"2 m\", \"1 m\"]\nradius = \"1 mm\"\n";

std::string zone_errors(const std::vector<std::string>& overrides) {
  return error_of([&] {
    CaseFile file = CaseFile::parse(zones_text, "case.toml", overrides);
    for (const TableView& view : file.array_of_tables("zone")) (void)samples::read<samples::Zone>(file, view);
    file.throw_if_errors();
  });
}

std::string material_errors(const std::vector<std::string>& overrides) {
  return error_of([&] {
    CaseFile file =
        CaseFile::parse("[material.concrete]\nlaw = \"a\"\nyoung_modulus = \"1 GPa\"\n", "case.toml", overrides);
    for (const TableView& view : file.named_tables("material")) (void)samples::read<samples::Material>(file, view);
    file.throw_if_errors();
  });
}

}  // namespace

TEST_CASE("overrides replace values and add them") {
  CaseFile file = CaseFile::parse(zones_text, "case.toml",
                                  {"zone.middle.radius=2 mm", "zone.left.to=[\"3 m\", \"4 m\"]", "solver.max_steps=7",
                                   "solver.verbose=true", "solver.tolerance=1e-3", "solver.max_steps=8"});
  const auto zones = file.array_of_tables("zone");
  CHECK(samples::read<samples::Zone>(file, zones[0]).to[1] == 4.0);
  CHECK(samples::read<samples::Zone>(file, zones[1]).radius == 0.002);
  const auto solver = samples::read<samples::Solver>(file, file.table("solver"));
  CHECK(solver.max_steps == 8);
  CHECK(solver.verbose);
  CHECK(solver.tolerance == 1e-3);
  CHECK(file.text() == zones_text);
  CHECK_NOTHROW(file.throw_if_errors());
}

TEST_CASE("a value that is no TOML is a string") {
  std::string title;
  Parameters top;
  top.text("title", title, "");
  const auto titled = [&](const std::string& override) {
    CaseFile file = CaseFile::parse("title = \"a\"\n", "case.toml", {override});
    file.read(file.top_level(), top);
    file.throw_if_errors();
    return title;
  };
  CHECK(titled("title=2 um/s") == "2 um/s");
  CHECK(titled("title=\"quoted\"") == "quoted");
  CHECK(titled("title=") == "");
  CHECK(titled("title=a=b") == "a=b");
  CHECK(titled("title=1\nseed = 2") == "1\nseed = 2");
}

TEST_CASE("errors in overridden values name the override") {
  CHECK(zone_errors({"zone.middle.radius=-1 mm"}) ==
        "--set zone.middle.radius=-1 mm: 'radius' is -1 mm, but must be greater than 0 m");
  CHECK(zone_errors({"zone.middle.to=[\"1 m\", 2]"}) ==
        "--set zone.middle.to=[\"1 m\", 2]: item 2 of 'to' is a bare number: expected a quantity in m (such as \"5 "
        "mm\")");
  CHECK(zone_errors({"zone.middle.raduis=1 mm"}) ==
        "--set zone.middle.raduis=1 mm: unknown key 'raduis' in [[zone]] 'middle'; did you mean 'radius'?");
}

TEST_CASE("a path that does not exist names the closest") {
  CHECK(zone_errors({"zone.midle.radius=1 mm"}) ==
        "--set zone.midle.radius=1 mm: there is no [[zone]] named 'midle' (there are: 'left', 'middle'); did you mean "
        "'middle'?");
  CHECK(zone_errors({"zoen.middle.radius=1 mm"}) ==
        "--set zoen.middle.radius=1 mm: unknown table [zoen]; did you mean 'zone'?");
  CHECK(
      material_errors({"material.concrte.law=b"}) ==
      "--set material.concrte.law=b: there is no [material.concrte] (there are: 'concrete'); did you mean 'concrete'?");
  CHECK(zone_errors({"zone.middle=1"}) == "--set zone.middle=1: 'zone.middle' is a table: name one of its keys");
  CHECK(zone_errors({"zone=1"}) == "--set zone=1: 'zone' is a table: name one of its keys");
  CHECK(material_errors({"material.concrete=1"}) ==
        "--set material.concrete=1: 'material.concrete' is a table: name one of its keys");
  CHECK(material_errors({"material.concrete.law.x=1"}) ==
        "--set material.concrete.law.x=1: 'material.concrete.law' is a string, which has no key 'x'");
  CHECK(error_of([] {
          CaseFile file = CaseFile::parse("[solver]\n", "case.toml", {"zone.middle.radius=1 mm"});
          (void)file.array_of_tables("zone");
          (void)file.has("solver");
          file.throw_if_errors();
        }) == "--set zone.middle.radius=1 mm: the case has no [[zone]]");
}

TEST_CASE("overrides reach into inner tables") {
  CaseFile file = CaseFile::parse("[[support]]\nname = \"left\"\nfix = [\"x\"]\nat = { x = \"1 m\" }\n", "case.toml",
                                  {"support.left.at.x=2 m", "support.left.at.y=3 m"});
  const auto support = samples::read<samples::Support>(file, file.array_of_tables("support").at(0));
  CHECK(support.x == 2.0);
  CHECK(support.y == 3.0);
}

TEST_CASE("an override must be key=value") {
  CHECK_THROWS_WITH_AS((void)parse_override("seed"), "--set 'seed': expected key=value, such as generation.seed=3",
                       InputError);
  CHECK_THROWS_WITH_AS((void)parse_override("a..b=3"), "--set 'a..b=3': 'a..b' is not a key, such as generation.seed",
                       InputError);
  CHECK_THROWS_AS((void)parse_override("=3"), InputError);
  CHECK_THROWS_AS((void)parse_override("a.=3"), InputError);
  CHECK(parse_override("a.b= 3").value == " 3");
}
