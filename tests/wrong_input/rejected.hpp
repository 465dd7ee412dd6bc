#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "../app/program.hpp"

/// Case files with a mistake: a good one with an edit, and the message it must get.
namespace ligament::test {

inline std::string good_case() { return content_of(LIGAMENT_SOURCE_DIR "/tests/wrong_input/good.toml"); }

/// The good case with one text, which it must have exactly once, replaced by another.
inline std::string edited(const std::string& from, const std::string& to, std::string text = good_case()) {
  const std::size_t place = text.find(from);
  REQUIRE_MESSAGE(place != std::string::npos, "the good case has no " << from);
  REQUIRE_MESSAGE(text.find(from, place + 1) == std::string::npos, "the good case has two " << from);
  return text.replace(place, from.size(), to);
}

/// "line:column" of the first character of a part of a text.
inline std::string place_of(const std::string& part, const std::string& text) {
  const std::size_t place = text.find(part);
  REQUIRE_MESSAGE(place != std::string::npos, "the case has no " << part);
  const auto begin = text.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(place);
  const auto line = 1 + std::count(begin, end, '\n');
  const std::size_t line_begin = place == 0 ? 0 : text.rfind('\n', place - 1) + 1;
  return std::to_string(line) + ":" + std::to_string(place - line_begin + 1);
}

/// `run` and `check` must refuse the case with exactly this on the error output, soon, and leave nothing behind.
inline void check_rejected(const std::string& text, const std::string& messages,
                           const std::vector<std::string>& options = {}) {
  const Workplace place;
  place.write("case.toml", text);
  for (const char* command : {"check", "run"}) {
    std::vector<std::string> arguments{command, "case.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto start = std::chrono::steady_clock::now();
    const Finished finished = place.run(arguments);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
    CHECK(finished.err == messages + "\n");
    CHECK(finished.code == 2);
    CHECK(finished.out.empty());
    CHECK(place.names() == std::vector<std::string>{"case.toml"});
  }
}

/// The good case with an edit must be refused with this message, placed at the first character of `at` (the edit itself
/// if that is empty).
inline void check_edit(const std::string& from, const std::string& to, const std::string& message,
                       const std::string& at = {}) {
  CAPTURE(to);
  const std::string text = edited(from, to);
  check_rejected(text, "case.toml:" + place_of(at.empty() ? to : at, text) + ": " + message);
}

}  // namespace ligament::test
