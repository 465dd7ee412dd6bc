#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "case_samples.hpp"
#include "io/parameter_docs.hpp"

using namespace ligament;
using samples::error_of;

namespace {

/// Descriptions whose owners are gone, as in the program.
std::vector<TableDescription> described() {
  std::vector<TableDescription> tables(4);
  std::string title;
  tables[0].parameters.text("title", title, "What the case is called.");

  samples::Problem problem;
  tables[1].path = "problem";
  tables[1].description = "The body.";
  tables[1].required = true;
  problem.declare(tables[1].parameters);

  tables[2].path = "material.*";
  tables[2].kind = TableDescription::Kind::named;
  tables[2].description = "Materials.";
  tables[2].selector = "law";
  double modulus = 0.0;
  double strength = std::numeric_limits<double>::infinity();
  tables[2].parameters.quantity("young_modulus", modulus, "Pa", "Young's modulus E.").required().greater_than(0.0);
  tables[2].variants.resize(2);
  tables[2].variants[0].name = "linear_elastic";
  tables[2].variants[0].description = "Never breaks.";
  tables[2].variants[1].name = "brittle";
  tables[2].variants[1].parameters.quantity("tensile_strength", strength, "Pa", "f_t | peak.");

  samples::Support support;
  tables[3].path = "support";
  tables[3].kind = TableDescription::Kind::array;
  support.declare(tables[3].parameters);
  return tables;
}

}  // namespace

TEST_CASE("explain finds keys by path, by element and by their last part") {
  const auto tables = described();
  const std::string modulus =
      "material.young_modulus: quantity in Pa, greater than 0 Pa, required\n"
      "  Young's modulus E.\n"
      "  Such as \"20 GPa\".\n";
  CHECK(explain(tables, "material.young_modulus") == modulus);
  CHECK(explain(tables, "material.concrete.young_modulus") == modulus);
  CHECK(explain(tables, "young_modulus") == modulus);
  CHECK(explain(tables, "problem.plane") ==
        "problem.plane: text, \"stress\", \"strain\", default \"stress\"\n  Stress state.\n");
  CHECK(explain(tables, "support.left.at.x").find("support.at.x: quantity in m, optional\n") == 0);
  CHECK(explain(tables, "tensile_strength").find("  With law = \"brittle\".\n") != std::string::npos);
  CHECK(explain(tables, "title").find("title: text, default \"\"\n") == 0);
}

TEST_CASE("explain of a table lists its keys") {
  const std::string text = explain(described(), "material");
  CHECK(text.find("[material.*]: Materials.\n  law = \"linear_elastic\": Never breaks.\n") == 0);
  CHECK(text.find("\nmaterial.law: text, \"linear_elastic\", \"brittle\", required\n") != std::string::npos);
  CHECK(text.find("\nmaterial.tensile_strength: ") != std::string::npos);
  CHECK(explain(described(), "support").find("\nsupport.name: text, required\n") != std::string::npos);
}

TEST_CASE("explain of an unknown key suggests one") {
  CHECK(error_of([] { (void)explain(described(), "material.yuong_modulus"); }) ==
        "no case file has a key 'material.yuong_modulus'; did you mean 'material.young_modulus'?");
  CHECK(error_of([] { (void)explain(described(), "thicknes"); }) ==
        "no case file has a key 'thicknes'; did you mean 'thickness'?");
  CHECK(error_of([] { (void)explain(described(), ""); }) == "no case file has a key ''");
}

TEST_CASE("the reference has a section a table and a row a key") {
  const std::string text = markdown_reference(described());
  CHECK(text.find("## Top level\n") != std::string::npos);
  CHECK(text.find("## `[problem]`\n\nThe body.\n\nEvery case must have it.\n") != std::string::npos);
  CHECK(text.find("| `plane` | text | `\"stress\"` | \"stress\", \"strain\" | Stress state. |\n") != std::string::npos);
  CHECK(text.find("| `thickness` | quantity in m | **required** | greater than 0 m | Thickness t. |\n") !=
        std::string::npos);
  CHECK(text.find("### `law = \"linear_elastic\"`\n\nNever breaks.\n\nNo further keys.\n") != std::string::npos);
  CHECK(text.find("| `tensile_strength` | quantity in Pa | — |  | f_t \\| peak. |\n") != std::string::npos);
  CHECK(text.find("| `at.x` | quantity in m | — |  | On this vertical. |\n") != std::string::npos);
  CHECK(text.back() == '\n');
  CHECK(text.find("\n\n\n") == std::string::npos);
}

TEST_CASE("the schema is JSON with the ranges and the choices") {
  const auto schema = nlohmann::json::parse(json_schema(described()));
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(schema["additionalProperties"] == false);
  CHECK(schema["required"] == nlohmann::json::array({"problem"}));
  const auto& problem = schema["properties"]["problem"];
  CHECK(problem["type"] == "object");
  CHECK(problem["additionalProperties"] == false);
  CHECK(problem["required"] == nlohmann::json::array({"thickness"}));
  CHECK(problem["properties"]["plane"]["enum"] == nlohmann::json::array({"stress", "strain"}));
  CHECK(problem["properties"]["plane"]["default"] == "stress");
  CHECK(problem["properties"]["thickness"]["description"] == "Thickness t. (greater than 0 m)");
  CHECK(problem["properties"]["thickness"].contains("pattern"));
}

TEST_CASE("the schema's variants bring their keys and named tables their names") {
  const auto schema = nlohmann::json::parse(json_schema(described()));
  const auto& material = schema["properties"]["material"]["additionalProperties"];
  CHECK(schema["properties"]["material"]["propertyNames"]["pattern"] == "^[A-Za-z0-9_-]+$");
  CHECK(material["unevaluatedProperties"] == false);
  CHECK(material["required"] == nlohmann::json::array({"law", "young_modulus"}));
  REQUIRE(material["allOf"].size() == 2);
  CHECK(material["allOf"][1]["if"]["properties"]["law"]["const"] == "brittle");
  CHECK(material["allOf"][1]["if"]["required"] == nlohmann::json::array({"law"}));
  CHECK(material["allOf"][1]["then"]["properties"].contains("tensile_strength"));
  CHECK_FALSE(material["allOf"][1]["then"]["properties"]["tensile_strength"].contains("default"));
  const auto& support = schema["properties"]["support"];
  CHECK(support["type"] == "array");
  CHECK(support["items"]["required"] == nlohmann::json::array({"name", "fix"}));
  CHECK(support["items"]["properties"]["fix"]["minItems"] == 1);
  CHECK(support["items"]["properties"]["at"]["properties"]["x"]["type"] == "string");
}
