#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "case_samples.hpp"
#include "io/case_file.hpp"
#include "scratch_folder.hpp"

using namespace ligament;
using samples::error_of;

namespace {

const char* const column_text = R"(# A column.
title = "Column"
[problem]
plane = "strain"
thickness = "20 mm"

[material.concrete]
law = "linear_elastic"
young_modulus = "21.9 GPa"
[material.aggregate]
law = "linear_elastic"
young_modulus = "40 GPa"
poisson_ratio = 0.25

[[zone]]
name = "middle"
from = ["1.6 m", "0 m"]
to = ["2.4 m", "1 m"]
[[zone]]
name = "end"
from = ["3 m", "0 m"]
to = ["4 m", "1 m"]
radius = "5 mm"

[[support]]
name = "left"
at = { x = "0 m" }
fix = ["x"]
)";

std::filesystem::path scratch(const std::string& name, const std::string& content) {
  const std::filesystem::path path = ligament::test::scratch_folder("case_file") / name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string syntax_error(const std::string& text) {
  return error_of([&] { (void)CaseFile::parse(text, "case.toml"); });
}

}  // namespace

TEST_CASE("a case file fills the members in SI units") {
  CaseFile file = CaseFile::parse(column_text, "case.toml");
  std::string title;
  Parameters top;
  top.text("title", title, "Title.");
  file.read(file.top_level(), top);
  CHECK(title == "Column");

  const auto problem = samples::read<samples::Problem>(file, file.table("problem"));
  CHECK(problem.plane == samples::Problem::Plane::strain);
  CHECK(problem.thickness == 0.02);

  const auto materials = file.named_tables("material");
  REQUIRE(materials.size() == 2);
  CHECK(materials[0].name() == "concrete");
  CHECK(materials[1].name() == "aggregate");
  const auto concrete = samples::read<samples::Material>(file, materials[0]);
  CHECK(concrete.young_modulus == 21.9e9);
  CHECK(concrete.poisson_ratio == 0.2);
  CHECK_FALSE(concrete.tensile_strength.has_value());
  CHECK(samples::read<samples::Material>(file, materials[1]).poisson_ratio == 0.25);

  const auto zones = file.array_of_tables("zone");
  REQUIRE(zones.size() == 2);
  CHECK(zones[0].name() == "middle");
  CHECK(samples::read<samples::Zone>(file, zones[0]).from[0] == 1.6);
  CHECK(samples::read<samples::Zone>(file, zones[1]).radius == 0.005);

  const auto support = samples::read<samples::Support>(file, file.array_of_tables("support").at(0));
  CHECK(support.x == 0.0);
  CHECK_FALSE(support.y.has_value());
  CHECK(support.fix == std::vector<std::string>{"x"});

  CHECK_FALSE(file.table("solver").present());
  CHECK(samples::read<samples::Solver>(file, file.table("solver")).max_steps == 1000);
  CHECK(file.named_tables("absent").empty());
  CHECK(file.array_of_tables("gauge").empty());
  CHECK_NOTHROW(file.throw_if_errors());
}

TEST_CASE("the text is kept byte for byte and the path as given") {
  const std::string text = "\xEF\xBB\xBFtitle = \"\xC2\xB5\"\r\n# end";
  const auto path = scratch("bytes.toml", text);
  const CaseFile file = CaseFile::load(path);
  CHECK(file.text() == text);
  CHECK(file.file_name() == path.string());
}

TEST_CASE("what is no case file is refused with its place") {
  CHECK(syntax_error("a = \n") ==
        "case.toml:1:5: syntax error: error while parsing key-value pair: expected value, saw '\\n'");
  CHECK(syntax_error("[a]\nb = 1\nb = 2\n").find("case.toml:3:5: syntax error: ") == 0);
  CHECK(syntax_error("[problem]\nplane = \"stress").find("case.toml:2:16: syntax error: ") == 0);
  CHECK(syntax_error("title = \"\xFF\"") == "case.toml:1:9: the file is not UTF-8 text");
  CHECK(syntax_error("") == "case.toml:1:1: the file is empty");
  CHECK(syntax_error("# only a remark\n\n") == "case.toml:1:1: the file is empty");
  CHECK(syntax_error(std::string("\0\1\2", 3)).find("case.toml:1:1: ") == 0);
}

TEST_CASE("a path that cannot be read is refused with the reason") {
  const std::string folder = ligament::test::scratch_folder("case_folder");
  CHECK(error_of([&] { (void)CaseFile::load(folder + "/absent.toml"); }) ==
        folder + "/absent.toml: cannot be read: No such file or directory");
  CHECK(error_of([&] { (void)CaseFile::load(folder); }) == folder + ": is a directory, not a case file");
  const auto path = scratch("syntax.toml", "a = [1,\n");
  CHECK(error_of([&] { (void)CaseFile::load(path); }).find(path.string() + ":") == 0);
}

TEST_CASE("peeking decides what else to declare") {
  CaseFile file = CaseFile::parse("[solver]\nmethod = \"relaxation\"\n[control]\n[other]\nkind = 3\n", "case.toml");
  CHECK(file.peek(file.table("solver"), "method") == "relaxation");
  CHECK(file.peek(file.table("solver"), "method", {"relaxation", "explicit"}) == "relaxation");
  CHECK(file.peek(file.table("control"), "kind", {"time"}, "time") == "time");
  CHECK_FALSE(file.has_errors());
  CHECK_FALSE(file.peek(file.table("control"), "kind").has_value());
  CHECK_FALSE(file.peek(file.table("other"), "kind").has_value());
  CHECK(error_of([&] { file.throw_if_errors(); }) ==
        "case.toml:3:1: missing key 'kind' in [control]\n"
        "case.toml:5:8: 'kind' must be a string, not an integer");
}

TEST_CASE("a wrong choice hides what depends on it") {
  CaseFile file = CaseFile::parse("[[zone]]\nname = \"a\"\ngenerator = \"randm\"\nporosity = 0.1\n", "case.toml");
  const TableView zone = file.array_of_tables("zone").at(0);
  CHECK_FALSE(file.peek(zone, "generator", {"random", "hexagonal"}).has_value());
  CHECK(error_of([&] { file.throw_if_errors(); }) ==
        "case.toml:3:13: 'generator' is 'randm', but must be one of 'random', 'hexagonal'; did you mean 'random'?");
}

TEST_CASE("positions lead to tables, values and back to the caller's own errors") {
  CaseFile file = CaseFile::parse(column_text, "case.toml");
  const TableView zone = file.array_of_tables("zone").at(1);
  CHECK(file.position(zone).line == 19);
  CHECK(file.position(zone, "radius").line == 23);
  CHECK(file.position(zone, "radius").column == 10);
  CHECK(file.position(zone, "absent").line == 19);
  CHECK(zone.where() == "in [[zone]] 'end'");
  file.add_error(file.position(zone, "radius"), "too large for the zone");
  CHECK(error_of([&] { file.throw_collected_errors(); }) == "case.toml:23:10: too large for the zone");
}

TEST_CASE("several lists may be read from one table") {
  CaseFile file = CaseFile::parse("[solver]\ntolerance = 1e-3\nx = [\"1 m\", \"2 m\"]\n", "case.toml");
  CHECK(samples::read<samples::Solver>(file, file.table("solver")).tolerance == 1e-3);
  CHECK(samples::read<samples::Mesh>(file, file.table("solver")).x.size() == 2);
  CHECK_NOTHROW(file.throw_if_errors());
}
