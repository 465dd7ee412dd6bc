#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// Young's modulus of the good case as this text must be refused with this message.
void check_modulus(const std::string& text, const std::string& message) {
  check_edit("\"20 GPa\"", "\"" + text + "\"",
             "'young_modulus': '" + text + "' " + message + ": expected a quantity in Pa (such as \"20 GPa\")",
             "\"" + text + "\"");
}

void check_unit(const std::string& number, const std::string& unit) {
  check_edit("\"0.05 m\"", "\"" + number + " " + unit + "\"",
             "'radius': '" + number + " " + unit + "': '" + unit +
                 "' is not a unit (names with exponents, joined by '*' and '/'): expected a quantity in m (such as "
                 "\"5 mm\")");
}

}  // namespace

TEST_CASE("texts that hold no finite number") {
  const std::string message = "is not a finite number, one space and a unit";
  for (const char* text : {"nan Pa", "inf GPa", "-inf GPa", "1e400 Pa", "1e-400 Pa", "GPa", "", "20GPa", " 20 GPa",
                           "1,5 GPa", "1_000 GPa", "+20 GPa", "0x10 GPa", "1e GPa"}) {
    check_modulus(text, message);
  }
  check_edit("\"20 GPa\"", "\"1e308 GPa\"", "'young_modulus': '1e308 GPa' is beyond the range of numbers in Pa");
}

TEST_CASE("zero with a sign is zero") {
  check_edit("\"20 GPa\"", "\"-0 GPa\"", "'young_modulus' is -0 GPa, but must be greater than 0 Pa");
  check_edit("\"0.05 m\"", "\"-0 m\"", "'radius' is -0 m, but must be greater than 0 m");
}

TEST_CASE("units of another kind") {
  check_modulus("20 kN", "is not a stress");
  check_modulus("20 kN/m", "is not a stress");
  check_modulus("20", "has no unit");
  check_edit("\"0.05 m\"", "\"0.05 m2\"",
             "'radius': '0.05 m2' is not a length: expected a quantity in m (such as \"5 mm\")");
  check_edit("\"20 GPa\"", "\"20 gpa\"",
             "'young_modulus': '20 gpa': unknown unit 'gpa': expected a quantity in Pa (such as \"20 GPa\")");
}

TEST_CASE("units that are written wrongly") {
  check_unit("3", "m 2");
  check_unit("3", " m");
  check_unit("3", "m ");
  check_unit("3", "m²");
  check_unit("3", "m*");
  check_unit("3", "/m");
  check_unit("3", "m10");
  check_unit("3", "°C");
}

TEST_CASE("both micro signs and u mean the same") {
  for (const char* text : {"50000 um", "50000 \u00B5m", "50000 \u03BCm", "5 cm", "0.05 metre"}) {
    CAPTURE(text);
    const Workplace place;
    place.write("case.toml", edited("0.05 m", text));
    const Finished finished = place.run({"check", "case.toml"});
    CHECK(finished.code == 0);
    CHECK(contains(finished.out, "252 particles"));
  }
}

TEST_CASE("texts without end are cut in messages") {
  const Workplace place;
  place.write("case.toml", edited("\"0.05 m\"", "\"" + std::string(1'000'000, 'x') + "\""));
  const Finished finished = place.run({"run", "case.toml"});
  CHECK(finished.code == 2);
  CHECK(finished.err.starts_with("case.toml:21:10: 'radius': 'xxx"));
  CHECK(finished.err.ends_with(
      "xxx' is not a finite number, one space and a unit: expected a quantity in m (such as \"5 mm\")\n"));
  CHECK(finished.err.size() < 1100);
  CHECK(place.names().size() == 1);
}

TEST_CASE("control characters of a quoted text do not reach the terminal") {
  check_edit("\"20 GPa\"", "\"20 GPa\\n\"",
             "'young_modulus': '20 GPa?': 'GPa?' is not a unit (names with exponents, joined by '*' and '/'): expected "
             "a quantity in Pa (such as \"20 GPa\")");
}
