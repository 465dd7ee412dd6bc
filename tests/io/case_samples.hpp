#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "io/case_file.hpp"

/// Tables with members behind them, read by the tests of case files.
namespace samples {

struct Problem {
  enum class Plane { stress, strain };
  Plane plane = Plane::stress;
  double thickness = 0.0;

  void declare(ligament::Parameters& parameters) {
    parameters.choice("plane", plane, {{"stress", Plane::stress}, {"strain", Plane::strain}}, "Stress state.");
    parameters.quantity("thickness", thickness, "m", "Thickness t.").required().greater_than(0.0);
  }
};

struct Material {
  std::string law;
  double young_modulus = 0.0;
  double poisson_ratio = 0.2;
  std::optional<double> tensile_strength;

  void declare(ligament::Parameters& parameters) {
    parameters.text("law", law, "Law.").required();
    parameters.quantity("young_modulus", young_modulus, "Pa", "E").required().greater_than(0.0);
    parameters.number("poisson_ratio", poisson_ratio, "nu").at_least(0.0).less_than(0.5);
    parameters.quantity("tensile_strength", tensile_strength, "Pa", "f_t");
  }
};

struct Zone {
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  double radius = 0.01;

  void declare(ligament::Parameters& parameters) {
    parameters.point("from", from, "m", "Corner.").required();
    parameters.point("to", to, "m", "Corner.").required();
    parameters.quantity("radius", radius, "m", "Radius.").greater_than(0.0);
  }
};

struct Support {
  std::optional<double> x;
  std::optional<double> y;
  std::vector<std::string> fix;

  void declare(ligament::Parameters& parameters) {
    ligament::Parameters& at = parameters.table("at", "Where.");
    at.quantity("x", x, "m", "On this vertical.");
    at.quantity("y", y, "m", "On this horizontal.");
    parameters.texts("fix", fix, "Directions.").required().length_at_least(1).one_of({"x", "y"});
  }
};

struct Mesh {
  std::vector<double> x;
  std::vector<std::int64_t> nodes{1, 2};
  std::vector<double> shares{0.25, 0.75};

  void declare(ligament::Parameters& parameters) {
    parameters.quantities("x", x, "m", "Columns.").length_at_least(2);
    parameters.integers("nodes", nodes, "Nodes.").at_least(1);
    parameters.numbers("shares", shares, "Shares.").at_most(1.0);
  }
};

struct Solver {
  double tolerance = 1e-6;
  std::int64_t max_steps = 1000;
  bool verbose = false;

  void declare(ligament::Parameters& parameters) {
    parameters.number("tolerance", tolerance, "Tolerance.").greater_than(0.0);
    parameters.integer("max_steps", max_steps, "Steps.").at_least(1);
    parameters.boolean("verbose", verbose, "Talk.");
  }
};

template <class Owner>
Owner read(ligament::CaseFile& file, const ligament::TableView& view) {
  Owner owner;
  ligament::Parameters parameters;
  owner.declare(parameters);
  file.read(view, parameters);
  return owner;
}

/// The message of the InputError that the call throws; empty if it throws none.
template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const ligament::InputError& error) {
    return error.what();
  }
  return {};
}

/// The errors of a text read as one table [section] of the owner's type.
template <class Owner>
std::string errors_in(const std::string& section, const std::string& text,
                      const std::vector<std::string>& overrides = {}) {
  return error_of([&] {
    ligament::CaseFile file = ligament::CaseFile::parse(text, "case.toml", overrides);
    (void)read<Owner>(file, file.table(section));
    file.throw_if_errors();
  });
}

}  // namespace samples
