#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace ligament::test;

namespace {

const std::string random_column = LIGAMENT_SOURCE_DIR "/config/column_random_r2.toml";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE_MESSAGE(place != std::string::npos, from);
  return text.replace(place, from.size(), to);
}

/// The random column with its assembly taken from a file.
std::string loading_column(const std::string& path) {
  std::string text = replaced(content_of(random_column), "generator = \"random\"", "generator = \"file\"");
  text = replaced(text, "smallest_radius = \"0.0075 m\"", "path = \"" + path + "\"");
  text = replaced(text, "largest_radius = \"0.015 m\"\n", "");
  return replaced(text, "count = 773\n", "");
}

nlohmann::json summary_of(const Workplace& place, const std::string& run) {
  return nlohmann::json::parse(content_of(place / run / "summary.json"));
}

nlohmann::json summary_after_steps(const Workplace& place, const std::string& path, const std::string& run) {
  const Finished finished = place.run({"run", path, "--output", run, "--stop-after-steps", "30", "--quiet"});
  CHECK(finished.err.empty());
  REQUIRE(finished.code == 0);
  return summary_of(place, run);
}

}  // namespace

TEST_CASE("a case that loads the assembly of another goes the same way, from HDF5 and from CSV") {
  const Workplace place;
  const auto expected = summary_after_steps(place, random_column, "generated");
  std::filesystem::create_directory(place / "assemblies");
  for (const char* extension : {"h5", "csv"}) {
    CAPTURE(extension);
    const std::string file = std::string("assemblies/r2.") + extension;
    const Finished generated = place.run({"generate", random_column, "--output", file});
    CHECK(generated.code == 0);
    CHECK(generated.err.empty());
    place.write("loading.toml", loading_column(file));
    const auto loaded = summary_after_steps(place, "loading.toml", extension);
    CHECK(loaded.at("final_state_hash") == expected.at("final_state_hash"));
    CHECK(loaded.at("packing") == expected.at("packing"));
    CHECK(loaded.at("case_hash") != expected.at("case_hash"));
    const std::string copy = std::string(extension) + "/inputs/1." + extension;
    CHECK(content_of(place / copy) == content_of(place / file));
  }
}

TEST_CASE("paths are relative to the case file, not to the working directory") {
  const Workplace place;
  std::filesystem::create_directory(place / "cases");
  place.write("cases/discs.csv", "x_m,y_m,radius_m\n2,0.5,0.1\n");
  place.write("cases/loading.toml", loading_column("discs.csv"));
  CHECK(contains(place.run({"check", "cases/loading.toml"}).out + place.run({"check", "cases/loading.toml"}).err,
                 "particle"));
  CHECK_FALSE(contains(place.run({"check", "cases/loading.toml"}).err, "no such file"));
}

TEST_CASE("another seed is another assembly, and the case hash knows what is in the file") {
  const Workplace place;
  place.write("loading.toml", loading_column("r2.csv"));
  REQUIRE(place.run({"generate", random_column, "--output", "r2.csv"}).code == 0);
  const auto first = summary_after_steps(place, "loading.toml", "first");
  REQUIRE(
      place.run({"generate", random_column, "--output", "r2.csv", "--overwrite", "--set", "generation.seed=2"}).code ==
      0);
  const auto second = summary_after_steps(place, "loading.toml", "second");
  CHECK(first.at("case_hash") != second.at("case_hash"));
  CHECK(first.at("final_state_hash") != second.at("final_state_hash"));
}

TEST_CASE("the report tells what came of the assembly beside what was asked for") {
  const Workplace place;
  const Finished finished = place.run({"generate", random_column, "--output", "r2.h5"});
  CHECK(contains(finished.out, "zone middle: random, 0.8 m × 0.34 m, seed 1\n"));
  CHECK(contains(finished.out, "n_particles                        773           773\n"));
  CHECK(contains(finished.out, "0.0075\n"));
  CHECK(contains(finished.out, "contact_anisotropy"));
  CHECK(contains(finished.out, "written to r2.h5\n"));
  CHECK(place.names() == std::vector<std::string>{"r2.h5"});
}

TEST_CASE("assemblies of several zones share a file, and are found by the names of the zones") {
  std::string text = content_of(LIGAMENT_SOURCE_DIR "/tests/wrong_input/good.toml");
  const std::string second =
      "[[zone]]\nname = \"second\"\nfrom = [\"0 m\", \"2 m\"]\nto = [\"1 m\", \"3 m\"]\ngenerator = \"random\"\n"
      "smallest_radius = \"0.02 m\"\nlargest_radius = \"0.04 m\"\narea_ratio = 1.1\nmaterial = \"rock\"\n\n";
  text = replaced(text, "[[support]]", second + "[[support]]");
  const Workplace place;
  place.write("two.toml", text);
  CHECK(contains(place.run({"generate", "two.toml", "--output", "two.csv"}).err,
                 "two.csv: a table holds one zone, and the case has 2: a name ending in .h5 would do"));
  REQUIRE(place.run({"generate", "two.toml", "--output", "two.h5"}).code == 0);
  const auto expected = summary_after_steps(place, "two.toml", "generated");
  text = replaced(text, "generator = \"random\"\nsmallest_radius = \"0.02 m\"\nlargest_radius = \"0.04 m\"\n",
                  "generator = \"file\"\npath = \"two.h5\"\n");
  text = replaced(text, "area_ratio = 1.1\n", "");
  text = replaced(text, "generator = \"hexagonal\"\nradius = \"0.05 m\"",
                  "generator = \"file\"\npath = \"two.h5\"\ndetection_gap = 1e-6\ninterface_gap = 0.5");
  place.write("loading.toml", text);
  CHECK(summary_after_steps(place, "loading.toml", "loaded").at("final_state_hash") == expected.at("final_state_hash"));
}

TEST_CASE("generate refuses what it cannot do, before it begins") {
  const Workplace place;
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Finished finished = place.run(arguments);
    CHECK(finished.code == 2);
    CHECK(finished.err == message + "\n");
    CHECK(finished.out.empty());
  };
  place.write("there.h5", "precious");
  std::filesystem::create_directory(place / "folder.h5");
  refused({"generate", random_column, "--output", "there.h5"}, "there.h5: exists; --overwrite replaces it");
  CHECK(content_of(place / "there.h5") == "precious");
  refused({"generate", random_column, "--output", "folder.h5", "--overwrite"}, "folder.h5: is a folder");
  refused({"generate", random_column, "--output", "r2.txt"}, "r2.txt: the name must end in .h5 or .csv");
  refused({"generate", random_column, "--output", "nowhere/r2.h5"}, "nowhere/r2.h5: there is no folder nowhere");
  const std::string elements = LIGAMENT_SOURCE_DIR "/config/column_fem.toml";
  refused({"generate", elements, "--output", "fem.h5"}, elements + ": has no zone to fill");
}

TEST_CASE("generate --overwrite replaces a file") {
  const Workplace place;
  place.write("r2.csv", "old");
  CHECK(place.run({"generate", random_column, "--output", "r2.csv", "--overwrite"}).code == 0);
  CHECK(content_of(place / "r2.csv").starts_with("x_m,y_m,radius_m\n"));
}
