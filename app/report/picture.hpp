#pragma once

#include <string>
#include <vector>

#include "core/vector.hpp"
#include "report/gnuplot.hpp"

namespace ligament {

struct Disc {
  Vector centre;
  double radius = 0.0;
};

/// Straight pieces from point to point.
struct Stroke {
  Field<Vector> points;
  double opacity = 1.0;
};

/// Shapes of one colour, with a line in the key if there is a title.
struct Layer {
  std::string name;
  std::string title;
  std::string colour;  ///< "#rrggbb"
  double width = 1.0;  ///< of strokes and outlines (pixels)
  std::vector<Disc> discs;
  std::vector<Stroke> strokes;
};

/// Discs and lines in their places, later layers over earlier ones: as SVG written here, since a disc is one word
/// there, and as PNG by gnuplot.
class Picture {
 public:
  void add(Layer layer);

  /// Writes `<layer>.dat` for gnuplot into the folder.
  [[nodiscard]] Figure figure(const std::string& name, const std::string& title,
                              const std::filesystem::path& folder) const;

 private:
  [[nodiscard]] double pixels_per_metre() const;
  [[nodiscard]] double size(int axis) const { return component(highest_ - lowest_, axis); }
  [[nodiscard]] std::string svg(const Figure& figure) const;
  [[nodiscard]] std::string svg_layer(const Layer& layer) const;
  [[nodiscard]] std::string svg_key(const Figure& figure) const;
  [[nodiscard]] std::string script(const Figure& figure) const;
  void include(const Vector& point, double around);

  std::vector<Layer> layers_;
  Vector lowest_ = uniform_vector(1e300);
  Vector highest_ = uniform_vector(-1e300);
};

}  // namespace ligament
