#include "rejected.hpp"

using namespace ligament::test;

namespace {

void check_path(const Workplace& place, const std::string& path, const std::string& message) {
  const auto before = place.names();
  for (const char* command : {"check", "run"}) {
    const Finished finished = place.run({command, path});
    CHECK(finished.code == 2);
    CHECK(finished.err == path + ": " + message + "\n");
    CHECK(place.names() == before);
  }
}

}  // namespace

TEST_CASE("files that are no text") {
  check_rejected("", "case.toml:1:1: the file is empty");
  check_rejected("# nothing but a comment\n", "case.toml:1:1: the file is empty");
  check_rejected(
      "title = \"Stra\xDF"
      "e\"\n",
      "case.toml:1:13: the file is not UTF-8 text");
  check_rejected(std::string("\xFF\xFEt\0i\0", 6), "case.toml:1:1: the file is not UTF-8 text");
}

TEST_CASE("binary files") {
  std::string bytes;
  for (int value = 0; value < 256; ++value) bytes += static_cast<char>(value);
  check_rejected(bytes,
                 "case.toml:1:1: syntax error: error while parsing root table: expected keys, tables, whitespace or "
                 "comments, saw '\\u0000'");
  check_rejected(
      "\x7F"
      "ELF\x02\x01\x01\xC0",
      "case.toml:1:7: the file is not UTF-8 text");
}

TEST_CASE("values and keys that are nested without end") {
  const std::string depth =
      ": syntax error: error while parsing value: exceeded maximum nested value depth of 256 (TOML_MAX_NESTED_VALUES)";
  check_rejected("x = " + std::string(100'000, '['), "case.toml:1:261" + depth);
  std::string inline_tables = "x = ";
  for (int i = 0; i < 10'000; ++i) inline_tables += "{a=";
  check_rejected(inline_tables, "case.toml:1:773" + depth);

  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  const std::string points = ":1: more than 1000 points without a '=' between them: no case file has such keys";
  check_rejected(key + " = 1\n", "case.toml:1" + points);
  check_rejected("\n[" + key + "]\n", "case.toml:2" + points);
}

TEST_CASE("syntax errors") {
  check_edit("[solver]", "[solver", "syntax error: error while parsing table header: expected ']', saw '\\n'",
             "\nmethod = \"dyn");
  check_edit("max_steps = 100", "max_steps = 100 200",
             "syntax error: error while parsing key-value pair: expected a comment or whitespace, saw '2'", "200");
}

TEST_CASE("a string without its end") {
  const std::string text = edited("\"20 GPa\"", "\"20 GPa");
  const Workplace place;
  place.write("case.toml", text);
  const Finished finished = place.run({"run", "case.toml"});
  CHECK(finished.code == 2);
  CHECK(contains(finished.err,
                 "a string holds a line break or another control character; is its closing quote missing?"));
  CHECK(contains(finished.err, "case.toml:8:"));
}

TEST_CASE("what is no file") {
  const Workplace place;
  std::filesystem::create_directory(place / "folder.toml");
  check_path(place, "folder.toml", "is a directory, not a case file");
  check_path(place, "nowhere.toml", "cannot be read: No such file or directory");
  check_path(place, "folder.toml/nowhere.toml", "cannot be read: No such file or directory");
}

TEST_CASE("a file without permission to read" * doctest::skip(::geteuid() == 0)) {
  const Workplace place;
  place.write("case.toml", good_case());
  std::filesystem::permissions(place / "case.toml", std::filesystem::perms::none);
  check_path(place, "case.toml", "cannot be read: Permission denied");
}

TEST_CASE("line ends and a byte order mark of other systems are no mistake") {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : good_case()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const Workplace place;
  place.write("case.toml", text);
  CHECK(place.run({"check", "case.toml"}).code == 0);
}
