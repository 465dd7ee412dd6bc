#include "report/curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/axis.hpp"
#include "report/load_curves.hpp"

namespace ligament {
namespace {

Figure curve(const CsvContent& table, const std::string& path, const std::string& abscissa,
             const std::string& ordinate) {
  const Axis x = axis_of(abscissa, table.numbers(abscissa));
  const Axis y = axis_of(ordinate, table.numbers(ordinate));
  const std::string script = fmt::format(
      "{}set xlabel {}\nset ylabel {}\nunset key\nplot {} using {}:{} with lines lw 1.6 lc rgb '{}'\n", curve_style,
      gnuplot_text(x.label), gnuplot_text(y.label), gnuplot_text(path), x.values(), y.values(), curve_colours[0]);
  return {.name = fmt::format("{}_over_{}", ordinate, abscissa),
          .title = fmt::format("{} over {}", ordinate, abscissa),
          .script = script};
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
  const UnitPrefix prefix = prefix_for(largest);
  std::string script =
      fmt::format("{}set xlabel 'time (s)'\nset ylabel 'energy ({}J)'\nset key outside right top Left reverse\nplot ",
                  curve_style, prefix.sign);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Axis axis{terms[i], "", 1.0 / prefix.size};
    script +=
        fmt::format("{} using (column('time_s')):{} with lines lw 1.6 dt {} lc rgb '{}' title {}{}", gnuplot_text(path),
                    axis.values(), i / curve_colours.size() + 1, curve_colours[i % curve_colours.size()],
                    gnuplot_text(name_in(terms[i])), i + 1 < terms.size() ? ", " : "");
  }
  if (terms.empty()) script += "NaN notitle";
  return {.name = "energy", .title = "Energy ledger", .script = script + "\n", .width = 820};
}

}  // namespace ligament
