#pragma once

#include <filesystem>
#include <string>

namespace ligament {

/// One drawing, as SVG and as PNG: the commands of gnuplot that make it.
struct Figure {
  std::string name;    ///< of its files, without ending
  std::string title;   ///< over it in the report
  std::string script;  ///< up to the command that plots
  std::string svg;     ///< if not empty, gnuplot draws the PNG only
  int width = 640;     ///< of the SVG; the PNG has three times as many pixels
  int height = 440;
};

/// Text in single quotes, as gnuplot reads it.
std::string gnuplot_text(const std::string& text);

/// Writes `<name>.gnuplot` into the folder and runs gnuplot there; leaves `<name>.svg` and `<name>.png`. Paths in
/// the script are relative to the folder. FileError if there is no gnuplot, or if it fails.
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace ligament
