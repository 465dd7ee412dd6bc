#include "rejected.hpp"

using namespace ligament::test;

namespace {

const std::string hexagonal = "generator = \"hexagonal\"\nradius = \"0.05 m\"";
const std::string loaded = "generator = \"file\"\npath = \"discs.csv\"";
const std::string random_zone = "generator = \"random\"\nsmallest_radius = \"0.04 m\"\nlargest_radius = \"0.05 m\"\n";

/// A zone filled from this table must be refused with this message.
void check_table(const std::string& content, const std::string& message) {
  CAPTURE(content);
  const Workplace place;
  const std::string text = edited(hexagonal, loaded);
  place.write("case.toml", text);
  place.write("discs.csv", content);
  for (const char* command : {"check", "run"}) {
    const Finished finished = place.run({command, "case.toml"});
    CHECK(finished.err == "case.toml:" + place_of("[[zone]]", text) + ": zone 'block': discs.csv: " + message + "\n");
    CHECK(finished.code == 2);
    CHECK(place.names().size() == 2);
  }
}

}  // namespace

TEST_CASE("tables of discs must fit the zone") {
  const std::string header = "x_m,y_m,radius_m\n1.5,1,0.1\n";
  check_table(header + "1.5,2.5,0.1\n", "row 2 has its centre at (1.5, 2.5) m, outside of the zone");
  check_table(header + "1.5,1.5,0\n", "row 2 has a radius of 0 m, which must be greater than 0 m");
  check_table(header + "1.5,1.5,-0.1\n", "row 2 has a radius of -0.1 m, which must be greater than 0 m");
  check_table(header + "nan,1.5,0.1\n", "row 2 has a number that is not finite");
  check_table(header + "1.5,1.5,inf\n", "row 2 has a number that is not finite");
  check_table(header + "1.7,1,0.1\n1.5,1,0.2\n", "rows 1 and 3 have the same centre");
  check_table(header + "1.5\n", "row 2 is '1.5', not three numbers between commas");
  check_table("x_m,y_m,radius_m\n", "holds no discs");
}

TEST_CASE("files of assemblies that are not there") {
  check_edit(hexagonal, loaded, "zone 'block': discs.csv: there is no such file", "[[zone]]");
  check_edit(hexagonal, "generator = \"file\"\npath = \".\"", "zone 'block': .: is no file", "[[zone]]");
  check_edit(hexagonal, "generator = \"file\"", "missing key 'path' in [[zone]] 'block'", "[[zone]]");
}

TEST_CASE("random assemblies that cannot be") {
  check_edit(hexagonal, random_zone,
             "zone 'block': a random assembly needs either 'count' or 'area_ratio'; none is given", "[[zone]]");
  check_edit(hexagonal, random_zone + "count = 10\narea_ratio = 1.1",
             "zone 'block': a random assembly needs either 'count' or 'area_ratio'; both are given", "[[zone]]");
  check_edit(hexagonal, random_zone + "area_ratio = 3", "'area_ratio' is 3, but must be greater than 0 and at most 1.5",
             "3\nmaterial");
  check_edit(hexagonal, random_zone + "area_ratio = 1.1\nradii = \"normal\"",
             "'radii' is 'normal', but must be one of 'uniform', 'log_uniform'", "\"normal\"");
}
