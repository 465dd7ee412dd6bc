#pragma once

#include <array>
#include <string>
#include <vector>

namespace ligament {

/// How curves look: the commands of gnuplot before each of them.
inline constexpr const char* curve_style =
    "set datafile separator ','\n"
    "set border 3 linewidth 0.8\n"
    "set tics nomirror out scale 0.6\n"
    "set grid linewidth 0.4 linecolor rgb '#dddddd'\n";

/// The colours of Okabe and Ito, which colour-blind readers can tell apart.
inline constexpr std::array<const char*, 7> curve_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                          "#E69F00", "#56B4E9", "#000000"};

/// A column of a table and how its axis counts it.
struct Axis {
  std::string column;
  std::string label;
  double factor = 1.0;

  /// The column for gnuplot's `using`.
  [[nodiscard]] std::string values() const;
};

/// The prefix of a unit for numbers up to this size, and what it stands for.
struct UnitPrefix {
  double size;
  const char* sign;
};
UnitPrefix prefix_for(double largest);

/// The largest size among those that are finite.
double largest_of(const std::vector<double>& values);

/// "tip_left_m" is "tip left" in m.
std::string name_in(const std::string& column);

/// The axis of a column with these values: "tip left (mm)".
Axis axis_of(const std::string& column, const std::vector<double>& values);

}  // namespace ligament
