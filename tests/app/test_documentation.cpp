#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace ligament::test;

namespace {

/// A file in config/ that a command of the program writes.
void check_in_step(const std::string& file, const std::string& command) {
  const Finished finished = Workplace().run({command});
  CHECK(finished.code == 0);
  const bool is_in_step = content_of(LIGAMENT_SOURCE_DIR "/config/" + file) == finished.out;
  CHECK_MESSAGE(is_in_step, "config/" << file << " is out of step: renew it with 'ligament " << command << " > config/"
                                      << file << "'");
}

}  // namespace

TEST_CASE("the reference of all keys is in step with the program") { check_in_step("case_reference.md", "reference"); }

TEST_CASE("the schema is in step with the program") { check_in_step("case.schema.json", "schema"); }

TEST_CASE("the schema knows what the program knows") {
  const auto schema = nlohmann::json::parse(Workplace().run({"schema"}).out);
  const auto& tables = schema.at("properties");
  for (const char* table : {"problem", "material", "mesh", "zone", "support", "motion", "load", "gauge", "solver",
                            "output", "checkpoint", "audit", "generation", "contact"}) {
    CHECK_MESSAGE(tables.contains(table), std::string(table));
  }
  CHECK(schema.contains("$schema"));
}

TEST_CASE("explain") {
  const Workplace place;
  const Finished key = place.run({"explain", "zone.radius"});
  CHECK(key.code == 0);
  CHECK(contains(key.out, "zone.radius: quantity in m, greater than 0 m, required"));
  const Finished table = place.run({"explain", "solver"});
  CHECK(table.code == 0);
  CHECK(contains(table.out, "solver.unbalanced_force_ratio: number, greater than 0"));
  CHECK(place.run({"explain", "young_modulus"}).code == 0);

  const Finished unknown = place.run({"explain", "radiusx"});
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "no case file has a key 'radiusx'; did you mean 'radius'?"));
  CHECK(place.run({"explain", "zone.tensile_strength"}).code == 2);
}
