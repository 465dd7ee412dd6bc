#include "report/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ligament {
namespace {

constexpr const char* style =
    "set datafile separator ','\n"
    "set border 3 linewidth 0.8\n"
    "set tics nomirror out scale 0.6\n"
    "set grid linewidth 0.4 linecolor rgb '#dddddd'\n";

/// The colours of Okabe and Ito, which colour-blind readers can tell apart.
constexpr std::array<const char*, 7> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                             "#E69F00", "#56B4E9", "#000000"};

/// A column and how its axis counts it.
struct Axis {
  std::string column;
  std::string label;
  double factor = 1.0;
};

struct Prefix {
  double size;
  const char* sign;
};

Prefix prefix_for(double largest) {
  for (const Prefix& prefix :
       {Prefix{1e9, "G"}, Prefix{1e6, "M"}, Prefix{1e3, "k"}, Prefix{1.0, ""}, Prefix{1e-3, "m"}, Prefix{1e-6, "µ"}}) {
    if (largest >= prefix.size) return prefix;
  }
  return largest > 0.0 ? Prefix{1e-9, "n"} : Prefix{1.0, ""};
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// "tip_left_m" is "tip left" in m.
std::string name_in(const std::string& column) {
  std::string name = column.substr(0, column.rfind('_'));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Axis axis_of(const CsvContent& table, const std::string& column) {
  const std::size_t cut = column.rfind('_');
  const std::string unit = cut == std::string::npos ? "" : column.substr(cut + 1);
  const Prefix prefix = unit == "s" ? Prefix{1.0, ""} : prefix_for(largest_of(table.numbers(column)));
  return {column, fmt::format("{} ({}{})", name_in(column), prefix.sign, unit), 1.0 / prefix.size};
}

std::string values_of(const Axis& axis) { return fmt::format("(column('{}')*{})", axis.column, axis.factor); }

Figure curve(const CsvContent& table, const std::string& path, const std::string& abscissa,
             const std::string& ordinate) {
  const Axis x = axis_of(table, abscissa);
  const Axis y = axis_of(table, ordinate);
  const std::string script = fmt::format(
      "{}set xlabel {}\nset ylabel {}\nunset key\nplot {} using {}:{} with lines lw 1.6 lc rgb '{}'\n", style,
      gnuplot_text(x.label), gnuplot_text(y.label), gnuplot_text(path), values_of(x), values_of(y), colours[0]);
  return {.name = fmt::format("{}_over_{}", ordinate, abscissa),
          .title = fmt::format("{} over {}", ordinate, abscissa),
          .script = script};
}

bool has_column(const CsvContent& table, const std::string& name) {
  return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
}

/// The gauges stand between the time and the number of broken bonds.
std::vector<std::string> gauges_of(const CsvContent& history) {
  const auto begin = static_cast<std::ptrdiff_t>(history.column_index("time_s")) + 1;
  const auto end = static_cast<std::ptrdiff_t>(history.column_index("n_broken"));
  return {history.columns.begin() + begin, history.columns.begin() + end};
}

/// A column in N, and columns in m to draw it over; either may be missing.
struct LoadCurves {
  std::string load;
  std::vector<std::string> displacements;
  bool are_named = true;
};

LoadCurves load_curves(const CsvContent& history) {
  const std::vector<std::string> gauges = gauges_of(history);
  const auto first_in = [&](const char* unit) {
    const auto found =
        std::find_if(gauges.begin(), gauges.end(), [&](const auto& name) { return name.ends_with(unit); });
    return found == gauges.end() ? std::string() : *found;
  };
  LoadCurves curves{has_column(history, "load_N") ? "load_N" : first_in("_N"), {}};
  for (const char* name : {"deflection_m", "cmod_m", "cmsd_m"}) {
    if (has_column(history, name)) curves.displacements.emplace_back(name);
  }
  curves.are_named = !curves.displacements.empty() && !curves.load.empty();
  if (curves.displacements.empty() && !first_in("_m").empty()) curves.displacements.push_back(first_in("_m"));
  if (curves.load.empty()) curves.displacements.clear();
  return curves;
}

}  // namespace

std::vector<Figure> gauge_figures(const CsvContent& history, const std::string& path) {
  std::vector<Figure> figures;
  const LoadCurves curves = load_curves(history);
  for (const std::string& name : curves.displacements) figures.push_back(curve(history, path, name, curves.load));
  if (curves.are_named) return figures;
  for (const std::string& name : gauges_of(history)) figures.push_back(curve(history, path, "time_s", name));
  return figures;
}

Figure energy_figure(const CsvContent& energy, const std::string& path) {
  std::vector<std::string> terms;
  double largest = 0.0;
  for (const std::string& column : energy.columns) {
    if (!column.ends_with("_J") || column == "defect_J") continue;
    const double size = largest_of(energy.numbers(column));
    if (size > 0.0) terms.push_back(column);
    largest = std::max(largest, size);
  }
  const Prefix prefix = prefix_for(largest);
  std::string script =
      fmt::format("{}set xlabel 'time (s)'\nset ylabel 'energy ({}J)'\nset key outside right top Left reverse\nplot ",
                  style, prefix.sign);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Axis axis{terms[i], "", 1.0 / prefix.size};
    script += fmt::format("{} using (column('time_s')):{} with lines lw 1.6 dt {} lc rgb '{}' title {}{}",
                          gnuplot_text(path), values_of(axis), i / colours.size() + 1, colours[i % colours.size()],
                          gnuplot_text(name_in(terms[i])), i + 1 < terms.size() ? ", " : "");
  }
  if (terms.empty()) script += "NaN notitle";
  return {.name = "energy", .title = "Energy ledger", .script = script + "\n", .width = 820};
}

}  // namespace ligament
