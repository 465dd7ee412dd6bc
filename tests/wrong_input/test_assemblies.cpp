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
  check_table(header + "1.5,1.5,1e300\n", "row 2 has a radius of 1e+300 m: its disc is larger than the zone");
}

TEST_CASE("tables that are damaged, or none") {
  const auto none = [](const std::string& begin) {
    return "is neither HDF5 nor a CSV file with the header 'x_m,y_m,radius_m' (it begins with '" + begin + "')";
  };
  check_table("", none(""));
  check_table("1.5,1,0.1\n", none("1.5,1,0.1"));
  check_table("x_m;y_m;radius_m\n1.5;1;0.1\n", none("x_m;y_m;radius_m"));
  check_table("x_m,y_m,radius_m\n1.5,1,0.1,2\n", "row 1 is '1.5,1,0.1,2', not three numbers between commas");
  check_table("x_m,y_m,radius_m\na,b,c\n", "row 1 is 'a,b,c', not three numbers between commas");
  check_table("x_m,y_m,radius_m\n1e400,1,0.1\n", "row 1 is '1e400,1,0.1', not three numbers between commas");
}

TEST_CASE("HDF5 files that are damaged") {
  const Workplace place;
  const std::string text = edited(hexagonal, "generator = \"file\"\npath = \"discs.h5\"");
  place.write("good.toml", good_case());
  REQUIRE(place.run({"generate", "good.toml", "--output", "discs.h5"}).code == 0);
  place.write("case.toml", text);
  REQUIRE(place.run({"check", "case.toml"}).code == 0);

  const std::string bytes = content_of(place / "discs.h5");
  std::string spoilt_head = bytes;
  spoilt_head.replace(40, 60, 60, '\xFF');
  const std::string signature = bytes.substr(0, 8);
  for (const std::string& content : {bytes.substr(0, bytes.size() / 2), signature, spoilt_head}) {
    place.write("discs.h5", content);
    const Finished finished = place.run({"run", "case.toml"});
    CHECK(finished.code == 2);
    CHECK(
        finished.err.starts_with("case.toml:" + place_of("[[zone]]", text) + ": zone 'block': cannot read discs.h5: "));
    CHECK(place.names().size() == 3);
  }
}

TEST_CASE("files of assemblies that are not there") {
  check_edit(hexagonal, loaded, "zone 'block': discs.csv: there is no such file", "[[zone]]");
  check_edit(hexagonal, "generator = \"file\"\npath = \".\"", "zone 'block': .: is no file", "[[zone]]");
  check_edit(hexagonal, "generator = \"file\"\npath = \"\"", "zone 'block': 'path' is empty: it names no file",
             "[[zone]]");
  check_edit(hexagonal, "generator = \"file\"\npath = \"/dev/zero\"", "zone 'block': /dev/zero: is no file",
             "[[zone]]");
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
