#include "rejected.hpp"

using namespace ligament::test;

namespace {

const std::string place_of_motion = "[[gauge]]\nname = \"r\"";

/// The good case with a motion of its right side that has these keys.
std::string with_motion(const std::string& keys) {
  return edited(place_of_motion, "[[motion]]\nname = \"pull\"\nat = { x = \"3 m\" }\ndirection = \"x\"\n" + keys +
                                     "\n" + place_of_motion);
}

void check_motion(const std::string& keys, const std::string& message, const std::string& at) {
  CAPTURE(keys);
  const std::string text = with_motion(keys);
  check_rejected(text, "case.toml:" + place_of(at, text) + ": " + message + " in [[motion]] 'pull'");
}

void check_schedule(const std::string& lists, const std::string& message) {
  check_motion("schedule = { " + lists + " }", message + " in 'schedule'", "{ " + lists);
}

}  // namespace

TEST_CASE("schedules of motions") {
  check_schedule(R"(time = ["0 s", "1 s"], displacement = ["0 mm"])",
                 "'time' has 2 items and 'displacement' 1: give one for each time");
  check_schedule(R"(time = ["0 s"], displacement = ["0 mm"])", "'time' needs at least two items");
  check_schedule(R"(time = ["1 s", "2 s"], displacement = ["0 mm", "1 mm"])", "'time' must begin with 0 s, not 1 s");
  check_schedule(R"(time = ["0 s", "2 s", "2 s"], displacement = ["0 mm", "1 mm", "2 mm"])",
                 "'time' must ascend, but 2 s follows 2 s");
  check_schedule(R"(time = ["0 s", "3 s", "2 s"], displacement = ["0 mm", "1 mm", "2 mm"])",
                 "'time' must ascend, but 2 s follows 3 s");
  check_schedule(R"(time = ["0 s", "1 s"], displacement = ["1 mm", "2 mm"])",
                 "'displacement' must begin with 0 m, not 0.001 m");
  const std::string good = R"(schedule = { time = ["0 s", "1 s"], displacement = ["0 mm", "1 mm"] })";
  check_motion(good + "\nvelocity = \"1 mm/s\"", "give one of 'velocity', 'displacement' and 'schedule'", "[[motion]]");
  check_motion(good + "\nstop_time = \"1 s\"",
               "there are times: leave 'rise_time' and 'stop_time' out, or the times in 'schedule'", "{ time");
  const std::string bare = with_motion(R"(schedule = { time = [0, "1 s"], displacement = ["0 mm", "1 mm"] })");
  check_rejected(bare, "case.toml:" + place_of("0, \"1 s\"", bare) +
                           ": item 1 of 'time' is a bare number: expected a quantity in s (such as \"1 ms\")");
  const std::string half = with_motion(R"(schedule = { time = ["0 s", "1 s"] })");
  check_rejected(half, "case.toml:" + place_of("{ time", half) +
                           ": missing key 'displacement' in 'schedule' in [[motion]] 'pull'");
}

TEST_CASE("schedules of loads") {
  const auto check = [](const std::string& keys, const std::string& message) {
    check_edit("force = [\"1 kN\", \"0 N\"]\n", "force = [\"1 kN\", \"0 N\"]\n" + keys + "\n",
               message + " in 'schedule' in [[load]] 'tip'", "{ time");
  };
  check(R"(schedule = { time = ["0 s", "1 s"], share = [0] })",
        "'time' has 2 items and 'share' 1: give one for each time");
  check(R"(schedule = { time = ["0 s", "0 s"], share = [0, 1] })", "'time' must ascend, but 0 s follows 0 s");
  check("rise_time = \"1 s\"\nschedule = { time = [\"0 s\", \"1 s\"], share = [0, 1] }",
        "there are times: leave 'rise_time' out, or the times");
}
