#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// `run` of the good case with these options must be refused with this message, and leave the file there is as it was.
void check_options(const std::vector<std::string>& options, int code, const std::string& message) {
  CAPTURE(options.front());
  CAPTURE(options.back());
  const Workplace place;
  place.write("case.toml", good_case());
  place.write("taken", "a text");
  std::vector<std::string> arguments{"run", "case.toml"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Finished finished = place.run(arguments);
  CHECK(finished.code == code);
  CHECK(contains(finished.err, message + "\n"));
  CHECK(content_of(place / "taken") == "a text");
  CHECK(place.names().size() == 2);
}

}  // namespace

TEST_CASE("an output that is a file") {
  const std::string message = "/taken: exists and is no run directory; choose another with --output";
  check_options({"--output", "taken"}, 2, message);
  check_options({"--output", "taken", "--overwrite"}, 2, message);
  check_options({"--output", "case.toml"}, 2,
                "/case.toml: exists and is no run directory; choose another with --output");
  check_options({"--output", "/dev/null"}, 2,
                "/dev/null: exists and is no run directory; choose another with --output");
  check_options({"--output", "taken/run"}, 5, "taken/run: cannot make the run directory: Not a directory");
}

TEST_CASE("an output without permission" * doctest::skip(::geteuid() == 0)) {
  const Workplace place;
  place.write("case.toml", good_case());
  std::filesystem::create_directory(place / "closed");
  std::filesystem::permissions(place / "closed", std::filesystem::perms::none);
  const Finished finished = place.run({"run", "case.toml", "--output", "closed/run"});
  CHECK(finished.code == 5);
  CHECK(finished.err == "closed/run: cannot make the run directory: Permission denied\n");
}

TEST_CASE("numbers of threads") {
  for (const std::string number : {"0", "-1", "1025", "abc", "1e9", "1.5", "", "999999999999999999999"}) {
    check_options({"--threads", number}, 2, "--threads: Value " + number + " not in range 1 to 1024");
  }
}

TEST_CASE("numbers of steps") {
  for (const std::string number : {"-1", "abc", "1.5"}) {
    check_options({"--stop-after-steps", number}, 2,
                  "--stop-after-steps: Value " + number + " not in range 0 to 9223372036854775807");
  }
}

TEST_CASE("words that the command does not know") {
  check_options({"more.toml"}, 2, "The following argument was not expected: more.toml");
  check_options({"--frobnicate"}, 2, "The following argument was not expected: --frobnicate");
}
