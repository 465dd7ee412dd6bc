#include "report/ensemble_figure.hpp"

#include <fmt/format.h>

#include "report/axis.hpp"

namespace ligament {

Figure ensemble_figure(const EnsemblePicture& picture) {
  const Axis x = axis_of(picture.abscissa, {picture.largest_x});
  const Axis y = axis_of(picture.load, {picture.largest_y});
  const auto scaled = [&](const std::string& prefix) { return Axis{prefix + y.column, "", y.factor}.values(); };
  const char* key = picture.groups.size() > 1 ? "set key below noenhanced" : "set key top right noenhanced";
  std::string script = fmt::format("{}set xlabel {}\nset ylabel {}\n{}\nplot ", curve_style, gnuplot_text(x.label),
                                   gnuplot_text(y.label), key);
  // The bands lie below, the means above all runs.
  std::string bands;
  std::string runs;
  std::string means;
  for (std::size_t i = 0; i < picture.groups.size(); ++i) {
    const EnsemblePicture::Group& group = picture.groups[i];
    const char* colour = curve_colours[i % curve_colours.size()];
    bands += fmt::format("{} using {}:{}:{} with filledcurves fs transparent solid 0.2 noborder lc rgb '{}' notitle, ",
                         gnuplot_text(group.mean), x.values(), scaled("lower_"), scaled("upper_"), colour);
    for (const std::string& run : group.runs) {
      runs += fmt::format("{} using {}:{} with lines lw 0.8 lc rgb '#a0a0a0' notitle, ", gnuplot_text(run), x.values(),
                          y.values());
    }
    means +=
        fmt::format("{} using {}:{} with lines lw 2 lc rgb '{}' title {}{}", gnuplot_text(group.mean), x.values(),
                    scaled("mean_"), colour, gnuplot_text(group.title), i + 1 < picture.groups.size() ? ", " : "\n");
  }
  return {.name = "ensemble",
          .title = fmt::format("{} over {}", picture.load, picture.abscissa),
          .script = script + bands + runs + means};
}

}  // namespace ligament
