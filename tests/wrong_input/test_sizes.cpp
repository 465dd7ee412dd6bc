#include "rejected.hpp"

using namespace ligament::test;

namespace {

const std::string hexagonal = "generator = \"hexagonal\"\nradius = \"0.05 m\"";

std::string random_zone(const std::string& smallest, const std::string& largest, const std::string& amount) {
  return "generator = \"random\"\nsmallest_radius = \"" + smallest + "\"\nlargest_radius = \"" + largest + "\"\n" +
         amount;
}

/// The zone filled at random must be refused with this message.
void check_random(const std::string& smallest, const std::string& largest, const std::string& amount,
                  const std::string& message) {
  check_edit(hexagonal, random_zone(smallest, largest, amount), "zone 'block': " + message, "[[zone]]");
}

std::string too_many(const std::string& count, const std::string& memory) {
  return "this would make " + count + " particles, which take some " + memory +
         " GB, and the limit is 2e+07 particles: larger particles or a smaller zone would do";
}

std::string grid_lines(int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += (i == 0 ? "\"" : ", \"") + std::to_string(i) + " m\"";
  return "[" + lines + "]";
}

}  // namespace

TEST_CASE("more particles than fit into a machine") {
  check_edit("\"0.05 m\"", "\"1 um\"", "zone 'block': " + too_many("5.77e+11", "4.04e+05"), "[[zone]]");
  check_edit("\"0.05 m\"", "\"1e-300 m\"", "zone 'block': " + too_many("inf", "inf"), "[[zone]]");
  check_random("0.04 m", "0.05 m", "count = 1000000000", too_many("1e+09", "700"));
  check_random("10 um", "20 um", "count = 9223372036854775807", too_many("9.22e+18", "6.46e+12"));
  check_random("1 um", "1 um", "area_ratio = 1.1", too_many("7e+11", "4.9e+05"));
  check_edit(hexagonal, random_zone("10 um", "20 um", "count = 99999999999999999999"),
             "syntax error: error while parsing decimal integer: '99999999999999999999' is not representable in 64 "
             "bits",
             "\nmaterial = \"rock\"\n\n[[support]]\nname = \"left\"");
}

TEST_CASE("more elements than fit into a machine") {
  const std::string lines = "\"0 m\", \"1 m\", \"2 m\", \"3 m\"]";
  const std::string text =
      edited("x = [" + lines, "x = " + grid_lines(5001), edited("y = [" + lines, "y = " + grid_lines(5001)));
  check_rejected(text, "case.toml:" + place_of("[mesh]", text) +
                           ": this would make 2.5e+07 elements, which take some 17.5 GB, and the limit is 2e+07 "
                           "elements: fewer grid lines would do");
}

TEST_CASE("area ratios and radii that cannot be packed") {
  const std::string range = ", but must be greater than 0 and at most 1.5";
  check_edit(hexagonal, random_zone("0.04 m", "0.05 m", "area_ratio = 0"), "'area_ratio' is 0" + range, "0\nmaterial");
  check_edit(hexagonal, random_zone("0.04 m", "0.05 m", "area_ratio = -1"), "'area_ratio' is -1" + range,
             "-1\nmaterial");
  check_edit(hexagonal, random_zone("0.04 m", "0.05 m", "area_ratio = 1.6"), "'area_ratio' is 1.6" + range,
             "1.6\nmaterial");
  check_random("0.04 m", "0.05 m", "count = 5000",
               "5000 discs of 0.04 m to 0.05 m radius have 16 times the area of the zone, and at most 1.5 can be "
               "packed: fewer or smaller discs would do");
  check_random("0.06 m", "0.05 m", "area_ratio = 1", "the smallest radius, 0.06 m, is larger than the largest, 0.05 m");
  check_random("0.04 m", "0.6 m", "area_ratio = 1", "discs of radius 0.6 m do not fit into 1 m × 2 m");
  check_random("1 um", "0.05 m", "area_ratio = 1.1\nradii = \"log_uniform\"",
               "log-uniform radii may differ by a factor of 1000 at most; these differ by 5e+04");
}

TEST_CASE("seeds") {
  check_edit("[solver]", "[generation]\nseed = -1\n\n[solver]", "'seed' is -1, but must be at least 0", "-1");
  check_edit("[solver]", "[generation]\nseed = 1.5\n\n[solver]",
             "'seed' must be an integer, not a number with a point or an exponent", "1.5");
  check_edit("[solver]", "[generation]\nseed = \"one\"\n\n[solver]", "'seed' must be an integer, not a string",
             "\"one\"");
  check_rejected(good_case(), "--set generation.seed=-1: 'seed' is -1, but must be at least 0",
                 {"--set", "generation.seed=-1"});
}
