#include "report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/atomic_file.hpp"

namespace ligament {
namespace {

constexpr double longest_side = 900.0;
constexpr double smallest_width = 520.0;
constexpr double margin = 10.0;
constexpr double key_line = 22.0;
constexpr int keys_per_line = 2;
constexpr const char* disc_colour = "#e6e6e6";

bool has_key(const Layer& layer) { return !layer.title.empty(); }

int key_lines(const std::vector<Layer>& layers) {
  const auto n_keys = static_cast<int>(std::count_if(layers.begin(), layers.end(), has_key));
  return (n_keys + keys_per_line - 1) / keys_per_line;
}

/// Transparency and colour in one number, as gnuplot takes them.
long colour_number(const std::string& colour, double opacity) {
  const long transparency = std::lround(255.0 * (1.0 - opacity));
  return (transparency << 24) + std::stol(colour.substr(1), nullptr, 16);
}

std::string data_of(const Layer& layer) {
  std::string data;
  const auto add = [&](const Vector& point, auto value) {
    data += fmt::format("{} {} {}\n", component(point, 0), component(point, 1), value);
  };
  for (const Disc& disc : layer.discs) add(disc.centre, disc.radius);
  for (const Stroke& stroke : layer.strokes) {
    for (const Vector& point : stroke.points) add(point, colour_number(layer.colour, stroke.opacity));
    data += "\n";
  }
  return data;
}

}  // namespace

void Picture::include(const Vector& point, double around) {
  for (int axis = 0; axis < dimension; ++axis) {
    set_component(lowest_, axis, std::min(component(lowest_, axis), component(point, axis) - around));
    set_component(highest_, axis, std::max(component(highest_, axis), component(point, axis) + around));
  }
}

void Picture::add(Layer layer) {
  if (layer.discs.empty() && layer.strokes.empty()) return;
  for (const Disc& disc : layer.discs) include(disc.centre, disc.radius);
  for (const Stroke& stroke : layer.strokes) {
    for (const Vector& point : stroke.points) include(point, 0.0);
  }
  layers_.push_back(std::move(layer));
}

double Picture::pixels_per_metre() const { return longest_side / std::max(size(0), size(1)); }

Figure Picture::figure(const std::string& name, const std::string& title, const std::filesystem::path& folder) const {
  for (const Layer& layer : layers_) write_atomically(folder / (layer.name + ".dat"), data_of(layer));
  Figure figure{.name = name, .title = title};
  figure.width = static_cast<int>(std::max(smallest_width, pixels_per_metre() * size(0) + 2.0 * margin));
  figure.height = static_cast<int>(pixels_per_metre() * size(1) + 3.0 * margin + key_line * key_lines(layers_));
  figure.script = script(figure);
  figure.svg = svg(figure);
  return figure;
}

std::string Picture::svg(const Figure& figure) const {
  // The middle of the model comes to the middle of the room above the key, and y points up.
  const Vector middle = 0.5 * pixels_per_metre() * (lowest_ + highest_);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<g transform=\"translate({2:.2f} {3:.2f})\">\n",
      figure.width, figure.height, 0.5 * figure.width - component(middle, 0),
      margin + 0.5 * pixels_per_metre() * size(1) + component(middle, 1));
  for (const Layer& layer : layers_) text += svg_layer(layer);
  return text + "</g>\n" + svg_key(figure) + "</svg>\n";
}

std::string Picture::svg_layer(const Layer& layer) const {
  const double scale = pixels_per_metre();
  std::string text = fmt::format("<g stroke=\"{}\" stroke-width=\"{}\" fill=\"{}\">\n", layer.colour, layer.width,
                                 layer.discs.empty() ? "none" : disc_colour);
  for (const Disc& disc : layer.discs) {
    text += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", scale * component(disc.centre, 0),
                        -scale * component(disc.centre, 1), scale * disc.radius);
  }
  for (const Stroke& stroke : layer.strokes) {
    text += "<polyline points=\"";
    for (const Vector& point : stroke.points) {
      text += fmt::format("{:.2f},{:.2f} ", scale * component(point, 0), -scale * component(point, 1));
    }
    text += stroke.opacity < 1.0 ? fmt::format("\" opacity=\"{:.2f}\"/>\n", stroke.opacity) : "\"/>\n";
  }
  return text + "</g>\n";
}

std::string Picture::svg_key(const Figure& figure) const {
  std::string text = "<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\">\n";
  int number = 0;
  const double top = figure.height - margin - key_line * key_lines(layers_) + 0.5 * key_line;
  for (const Layer& layer : layers_) {
    if (!has_key(layer)) continue;
    const double left = 0.5 * figure.width - 190.0 + 200.0 * (number % keys_per_line);
    const int line = number / keys_per_line;
    const double height = top + key_line * line;
    text += fmt::format(
        "<path d=\"M{:.1f} {:.1f}h28\" stroke=\"{}\" stroke-width=\"{}\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        left, height, layer.colour, layer.width, left + 36.0, height + 4.5, layer.title);
    ++number;
  }
  return text + "</g>\n";
}

std::string Picture::script(const Figure& figure) const {
  const double key_height = key_line * key_lines(layers_) + margin;
  std::string text = fmt::format(
      "unset border\nunset tics\nset size ratio -1\nset lmargin 0\nset rmargin 0\n"
      "set bmargin at screen {}\nset tmargin at screen {}\n"
      "set key at screen 0.5,{} center center vertical maxrows {} Left reverse samplen 2\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\nplot ",
      key_height / figure.height, 1.0 - margin / figure.height, 0.5 * key_height / figure.height,
      std::max(1, key_lines(layers_)), component(lowest_, 0), component(highest_, 0), component(lowest_, 1),
      component(highest_, 1));
  for (const Layer& layer : layers_) {
    const std::string title = has_key(layer) ? "title " + gnuplot_text(layer.title) : "notitle";
    text += fmt::format("{}'{}.dat' using 1:2:3 with ", &layer == layers_.data() ? "" : ", ", layer.name);
    text += layer.discs.empty() ? fmt::format("lines lw {} lc rgb variable notitle", layer.width)
                                : fmt::format("circles fs solid 1 border rgb '{}' fc rgb '{}' lw {} {}", layer.colour,
                                              disc_colour, layer.width, title);
    // The key is opaque.
    if (layer.discs.empty() && has_key(layer)) {
      text += fmt::format(", NaN with lines lw {} lc rgb '{}' {}", layer.width, layer.colour, title);
    }
  }
  return text + "\n";
}

}  // namespace ligament
