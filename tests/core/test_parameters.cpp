#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "core/closest_name.hpp"
#include "core/parameters.hpp"
#include "core/registry.hpp"

using namespace ligament;

namespace {

enum class Plane { stress, strain };

struct Owner {
  double modulus = 2e10;
  std::optional<double> strength;
  std::array<double, 2> from{1.0, 2.0};
  std::optional<std::array<double, 2>> to;
  std::vector<double> x{0.5};
  std::int64_t seed = 7;
  bool on = true;
  std::string title = "none";
  Plane plane = Plane::strain;
  std::optional<Plane> other_plane;
};

Parameters declared(Owner& owner) {
  Parameters list;
  list.quantity("modulus", owner.modulus, "Pa", "E").greater_than(0.0);
  list.quantity("strength", owner.strength, "Pa", "f");
  list.point("from", owner.from, "m", "corner");
  list.point("to", owner.to, "m", "corner");
  list.quantities("x", owner.x, "m", "columns").length_at_least(1);
  list.integer("seed", owner.seed, "seed").at_least(0);
  list.boolean("on", owner.on, "switch");
  list.text("title", owner.title, "title").required();
  list.choice("plane", owner.plane, {{"stress", Plane::stress}, {"strain", Plane::strain}}, "plane");
  list.choice("other_plane", owner.other_plane, {{"stress", Plane::stress}, {"strain", Plane::strain}}, "plane");
  return list;
}

struct Shape {
  virtual ~Shape() = default;
  [[nodiscard]] virtual int corners() const = 0;
};
struct Triangle : Shape {
  [[nodiscard]] int corners() const override { return 3; }
};
struct Square : Shape {
  [[nodiscard]] int corners() const override { return 4; }
};

Registry<Shape> shapes() {
  Registry<Shape> registry("shape");
  registry.add("triangle", "three corners", [] { return std::make_unique<Triangle>(); });
  registry.add("square", "four corners", [] { return std::make_unique<Square>(); });
  return registry;
}

}  // namespace

TEST_CASE("a parameter's default is its member's value at declaration") {
  Owner owner;
  const Parameters list = declared(owner);
  owner.modulus = 0.0;
  CHECK(std::get<double>(*list.find("modulus")->default_value) == 2e10);
  CHECK_FALSE(list.find("strength")->default_value.has_value());
  CHECK_FALSE(list.find("title")->default_value.has_value());
  CHECK(std::get<std::string>(*list.find("plane")->default_value) == "strain");
  CHECK_FALSE(list.find("other_plane")->default_value.has_value());
  CHECK(std::get<std::vector<double>>(*list.find("from")->default_value) == std::vector<double>{1.0, 2.0});
}

TEST_CASE("assigning reaches the member and reads back") {
  Owner owner;
  const Parameters list = declared(owner);
  const auto assign = [&](const char* name, const ParameterValue& value) {
    list.find(name)->assign(value);
    CHECK(list.find(name)->current() == value);
  };
  assign("modulus", 1.5);
  assign("strength", 2.5);
  assign("to", std::vector<double>{3.0, 4.0});
  assign("x", std::vector<double>{1.0, 2.0});
  assign("seed", std::int64_t{11});
  assign("on", false);
  assign("title", std::string("beam"));
  assign("plane", std::string("stress"));
  assign("other_plane", std::string("strain"));
  CHECK(owner.modulus == 1.5);
  CHECK(owner.strength == 2.5);
  CHECK((*owner.to)[1] == 4.0);
  CHECK(owner.x.size() == 2);
  CHECK(owner.seed == 11);
  CHECK_FALSE(owner.on);
  CHECK(owner.title == "beam");
  CHECK(owner.plane == Plane::stress);
  CHECK(owner.other_plane == Plane::strain);
}

TEST_CASE("complaints say what would do") {
  double ratio = 0.2;
  std::string plane = "stress";
  std::vector<double> x;
  Parameters list;
  list.quantity("ratio", ratio, "m", "").greater_than(0.0).less_than(0.5);
  list.text("plane", plane, "").one_of({"stress", "strain"});
  list.quantities("x", x, "m", "").length(2);
  list.quantities("y", x, "m", "").length_at_least(1);
  const Parameter& number = *list.find("ratio");
  CHECK_FALSE(number.complaint(0.3).has_value());
  CHECK(number.complaint(0.5) == "must be greater than 0 m and less than 0.5 m");
  CHECK(number.complaint(0.0).has_value());
  CHECK(number.complaint(std::numeric_limits<double>::quiet_NaN()) == "must be finite");
  CHECK(number.complaint(std::numeric_limits<double>::infinity()) == "must be finite");
  CHECK(list.find("plane")->complaint(std::string("strss")) ==
        "must be one of 'stress', 'strain'; did you mean 'stress'?");
  CHECK_FALSE(list.find("plane")->complaint(std::string("strain")).has_value());
  CHECK(list.find("x")->complaint_about_length(3) == "must have 2 items");
  CHECK(list.find("y")->complaint_about_length(0) == "must have at least 1 item");
  CHECK_FALSE(list.find("y")->complaint_about_length(9).has_value());
}

TEST_CASE("ranges include or exclude their bounds") {
  CHECK(Range{.at_least = 1.0, .greater_than = {}, .at_most = 2.0, .less_than = {}}.contains(1.0));
  CHECK(Range{.at_least = 1.0, .greater_than = {}, .at_most = 2.0, .less_than = {}}.contains(2.0));
  CHECK_FALSE(Range{.at_least = {}, .greater_than = 1.0, .at_most = {}, .less_than = {}}.contains(1.0));
  CHECK(Range{}.text("m").empty());
  CHECK(Range{.at_least = 1.0, .greater_than = {}, .at_most = {}, .less_than = {}}.text("") == "at least 1");
}

TEST_CASE("inner tables keep their place while more is declared") {
  double x = 0.0;
  bool present = true;
  Parameters list;
  Parameters& at = list.table("at", present, "where");
  for (int i = 0; i < 100; ++i) list.number("n" + std::to_string(i), x, "");
  at.quantity("x", x, "m", "coordinate");
  CHECK(list.find("at")->fields.front().find("x") != nullptr);
  CHECK(list.find("at")->presence == &present);
  CHECK_FALSE(list.find("at")->required);
  list.require_table("at");
  CHECK(list.find("at")->required);
  CHECK_THROWS_AS(list.require_table("n1"), std::logic_error);
}

TEST_CASE("a second declaration of a name is a programmer's error") {
  double x = 0.0;
  Parameters list;
  list.number("x", x, "");
  CHECK_THROWS_WITH_AS(list.number("x", x, ""), "parameter 'x' is declared twice", std::logic_error);
  CHECK_THROWS_AS((void)list.given("y"), std::logic_error);
  CHECK_FALSE(list.given("x"));
}

TEST_CASE("a registry makes what it is asked for by name") {
  const Registry<Shape> registry = shapes();
  CHECK(registry.create("triangle")->corners() == 3);
  CHECK(registry.create("square")->corners() == 4);
  CHECK(registry.contains("square"));
  CHECK_FALSE(registry.contains("circle"));
  CHECK(registry.names() == std::vector<std::string>{"square", "triangle"});
  CHECK(registry.description("square") == "four corners");
}

TEST_CASE("an unknown name is answered with the known ones") {
  Registry<Shape> registry = shapes();
  CHECK_THROWS_WITH_AS((void)registry.create("sqaure"),
                       "unknown shape 'sqaure': known are 'square', 'triangle'; did you mean 'square'?", InputError);
  CHECK_THROWS_WITH_AS((void)registry.create("zzz"), "unknown shape 'zzz': known are 'square', 'triangle'", InputError);
  CHECK_THROWS_AS(registry.add("square", "again", [] { return std::make_unique<Square>(); }), std::logic_error);
}

TEST_CASE("the closest name is a misspelling, not a guess") {
  const std::vector<std::string> known{"tensile_strength", "cohesion", "x"};
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ab", "ba") == 1);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(closest_name("tensile_strenght", known) == "tensile_strength");
  CHECK(closest_name("cohession", known) == "cohesion");
  CHECK_FALSE(closest_name("density", known).has_value());
  CHECK_FALSE(closest_name("y", known).has_value());
  CHECK(did_you_mean("cohesoin", known) == "; did you mean 'cohesion'?");
  CHECK(did_you_mean("density", known).empty());
}
