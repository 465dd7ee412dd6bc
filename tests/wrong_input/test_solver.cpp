#include "rejected.hpp"

using namespace ligament::test;

namespace {

const std::string two_level = "method = \"two_level_relaxation\"\n";

void check_two_level(const std::string& key, const std::string& message, const std::string& at) {
  const std::string dense = edited("poisson_ratio = 0.2", "poisson_ratio = 0.2\ndensity = \"2400 kg/m3\"");
  const std::string text = edited("method = \"dynamic_relaxation\"\n", two_level + key, dense);
  check_rejected(text, "case.toml:" + place_of(at, text) + ": " + message);
}

}  // namespace

TEST_CASE("relaxation with masses of two levels") {
  check_two_level(
      "masses = \"real\"\n",
      "method = \"two_level_relaxation\" makes its own masses and cannot take masses = \"real\"; dynamics is "
      "method = \"undamped\"",
      "\"real\"");
  check_two_level("time_step = \"2 s\"\n",
                  "method = \"two_level_relaxation\" has steps of 1 s of pseudo-time: leave 'time_step' out",
                  "\"2 s\"");
  check_two_level("coarse_cell = \"0 m\"\n", "'coarse_cell' is 0 m, but must be greater than 0 m",
                  "\"0 m\"\nmax_steps");
  check_two_level("largest_damping = 2\n", "'largest_damping' is 2, but must be greater than 0 and less than 2",
                  "2\nmax_steps");
  check_two_level("damping_ratio = 0.9\n", "unknown key 'damping_ratio' in [solver]", "damping_ratio");
}

TEST_CASE("numbers of the solver that cannot be") {
  const auto check = [](const std::string& line, const std::string& message) {
    check_edit("max_steps = 100", "max_steps = 100\n" + line, message, line.substr(line.find(" = ") + 3) + "\n");
  };
  check("mass_safety = 0.5", "'mass_safety' is 0.5, but must be at least 1");
  check("mass_safety = nan", "'mass_safety' is nan, but must be finite");
  check("time_step_factor = 2.5", "'time_step_factor' is 2.5, but must be greater than 0 and at most 1");
  check("time_step = \"-1 s\"", "'time_step' is -1 s, but must be greater than 0 s");
  check("unbalanced_force_ratio = -3", "'unbalanced_force_ratio' is -3, but must be greater than 0");
  check("unbalanced_force_ratio = -0.0", "'unbalanced_force_ratio' is -0, but must be greater than 0");
  check("damping_ratio = -7", "'damping_ratio' is -7, but must be greater than 0");
}

TEST_CASE("a gauge that cannot be followed") {
  const auto check = [](const std::string& control, const std::string& messages, const std::string& method = "secant") {
    const std::string text = edited("method = \"dynamic_relaxation\"\n",
                                    "method = \"" + method + "\"\nincrement = \"1 um\"\n" + control + "\n");
    // The value, or the key.
    const std::string place = "case.toml:" + place_of(control, text) + (method == "secant" ? "1: " : ": ");
    std::string expected = messages;
    for (std::size_t at = 0; (at = expected.find('@', at)) != std::string::npos;) expected.replace(at, 1, place);
    check_rejected(text, expected);
  };
  const std::string no_motion = "@nothing can drive the gauge 'u' in [solver]: there is no [[motion]]";
  check("control = \"u\"", no_motion);
  check("control = \"cmod\"",
        "@there is no gauge 'cmod' in [solver] (there are: 'u', 'r')\n"
        "@nothing can drive the gauge 'cmod' in [solver]: there is no [[motion]]");
  check("control = \"r\"",
        "@the gauge 'r' in [solver] measures no displacement or opening, and no other can be followed\n"
        "@nothing can drive the gauge 'r' in [solver]: there is no [[motion]]");
  check("control = \"u\"", "@unknown key 'control' in [solver]", "quasi_static");
}
