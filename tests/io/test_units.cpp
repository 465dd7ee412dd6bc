#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "io/units.hpp"

using namespace ligament;

TEST_CASE("quantities are the doubles nearest to their decimals") {
  CHECK(to_si("1879 kg/m3", "kg/m3") == 1879.0);
  CHECK(to_si("2.4 g/cm3", "kg/m3") == 2400.0);
  CHECK(to_si("2 um/s", "m/s") == 2e-6);
  CHECK(to_si("2 \xC2\xB5m/s", "m/s") == 2e-6);
  CHECK(to_si("2 \xCE\xBCm/s", "m/s") == 2e-6);
  CHECK(to_si("21.9 GPa", "Pa") == 21.9e9);
  CHECK(to_si("20 GPa", "Pa") == 2e10);
  CHECK(to_si("7 kN/m", "N/m") == 7e3);
  CHECK(to_si("-1.65 kN", "N") == -1650.0);
  CHECK(to_si("10 N/m", "N/m") == 10.0);
  CHECK(to_si("70 J/m2", "N/m") == 70.0);
  CHECK(to_si("35 N/mm^2", "Pa") == 35e6);
  CHECK(to_si("9.81 m/s^2", "m/s2") == 9.81);
  CHECK(to_si("1e-3 s", "s") == 1e-3);
  CHECK(to_si("0.33 m", "m") == 0.33);
  CHECK(to_si("0.02 mm", "m") == 2e-5);
  CHECK(to_si("1.5E+2 mm", "m") == 0.15);
  CHECK(to_si("3 kN*m", "N*m") == 3000.0);
  CHECK(to_si("50 s^-1", "Hz") == 50.0);
}

TEST_CASE("scales that are no power of ten") {
  CHECK(to_si("90 deg", "rad") == std::acos(0.0));
  CHECK(to_si("2 h", "s") == 7200.0);
  CHECK(to_si("1 inch", "m") == 0.0254);
}

TEST_CASE("every power of ten between a number and its SI value costs no rounding") {
  for (int i = 1; i < 500; ++i) {
    const std::string number = std::to_string(i) + ".0" + std::to_string(i);
    CHECK(to_si(number + " mm", "m") == std::stod(number + "e-3"));
    CHECK(to_si(number + " um", "m") == std::stod(number + "e-6"));
    CHECK(to_si(number + " MPa", "Pa") == std::stod(number + "e6"));
    CHECK(to_si(number + " N/mm", "N/m") == std::stod(number + "e3"));
  }
}

TEST_CASE("the SI text reads back to the same bits") {
  CHECK(si_text(2.19e10, "Pa") == "2.19e+10 Pa");
  for (const double value : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0, 2e10, 1e-5}) {
    const double again = to_si(si_text(value, "Pa"), "Pa");
    CHECK(again == value);
    CHECK(std::signbit(again) == std::signbit(value));
  }
}

TEST_CASE("messages say what is wrong and what would do") {
  CHECK_THROWS_WITH_AS((void)to_si("20 kg", "Pa"),
                       "'20 kg' is not a stress: expected a quantity in Pa (such as \"20 GPa\")", UnitError);
  CHECK_THROWS_WITH_AS((void)to_si("20", "Pa"), "'20' has no unit: expected a quantity in Pa (such as \"20 GPa\")",
                       UnitError);
  CHECK_THROWS_WITH_AS((void)to_si("20 GPq", "Pa"),
                       "'20 GPq': unknown unit 'GPq': expected a quantity in Pa (such as \"20 GPa\")", UnitError);
  CHECK_THROWS_WITH_AS(
      (void)to_si("3 m 2", "m"),
      "'3 m 2': 'm 2' is not a unit (names with exponents, joined by '*' and '/'): expected a quantity "
      "in m (such as \"5 mm\")",
      UnitError);
  CHECK_THROWS_WITH_AS((void)to_si("20GPa", "Pa"),
                       "'20GPa' is not a finite number, one space and a unit: expected a quantity in Pa (such as "
                       "\"20 GPa\")",
                       UnitError);
  CHECK_THROWS_WITH_AS((void)to_si("5 A", "kg/m2"),
                       "'5 A' is not measured in kg/m2: expected a quantity in kg/m2 (such as \"1 kg/m2\")", UnitError);
  CHECK_THROWS_WITH_AS((void)to_si("1e308 GPa", "Pa"), "'1e308 GPa' is beyond the range of numbers in Pa", UnitError);
}

TEST_CASE("what UDUNITS would take and we do not") {
  for (const char* text :
       {"3 m 2", "nan m",  "inf m", "-inf m", "1e400 m", "",        " ",      "m",     "5",       "5 ",    " 5 m",
        "5 m ",  "5  m",   "5m",    "0x10 m", "1,5 m",   "1_000 m", "5 m\n",  "5 (m)", "5 m^",    "5 m^-", "5 m/",
        "5 *m",  "5 m**2", "5 m.s", "5 1/m",  "5 m@3",   "5 lg(m)", "5 m^22", "+5 m",  "5 \xC2m", "five m"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)to_si(text, "m"), UnitError);
  }
}

TEST_CASE("reciprocals and scales with another zero are other dimensions") {
  CHECK_THROWS_AS((void)to_si("10 Hz", "s"), UnitError);
  CHECK_THROWS_AS((void)to_si("20 degC", "K"), UnitError);
  CHECK(to_si("20 K", "K") == 20.0);
}

TEST_CASE("a wrong unit in a declaration is a programmer's error") {
  CHECK_THROWS_AS((void)to_si("20 GPa", "Pq"), std::logic_error);
  CHECK_NOTHROW(check_unit("kg/m3"));
  CHECK_THROWS_AS(check_unit("kg / m3"), UnitError);
  CHECK_THROWS_AS(check_unit("Pq"), UnitError);
}
