#include "report/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "report/crack_picture.hpp"
#include "report/curves.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>{0}</title>
<style>
body {{ font-family: Helvetica, Arial, sans-serif; color: #222; max-width: 60em; margin: 2em auto; padding: 0 1em; }}
h1 {{ font-size: 1.5em; }}
h2 {{ font-size: 1.1em; margin-top: 2em; }}
svg {{ max-width: 100%; height: auto; }}
table {{ border-collapse: collapse; }}
td {{ padding: 0.15em 1.5em 0.15em 0; border-bottom: 1px solid #ddd; vertical-align: top; }}
td + td {{ font-family: monospace; }}
</style>
</head>
<body>
<h1>{0}</h1>
)";

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

/// An SVG file without what stands before its root: it goes into the page as it is.
std::string inline_svg(const fs::path& path) {
  const std::string content = read_file(path);
  const std::size_t begin = content.find("<svg");
  return begin == std::string::npos ? "" : content.substr(begin);
}

std::string value_of(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// One row per number; those of a group have its name before theirs.
void add_rows(const std::string& prefix, const Json& values, std::string& html) {
  for (const auto& [name, value] : values.items()) {
    if (value.is_object()) {
      add_rows(prefix + name + ".", value, html);
    } else {
      html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(prefix + name), escaped(value_of(value)));
    }
  }
}

std::string summary_table(const fs::path& run) {
  const fs::path path = run / "summary.json";
  if (!fs::exists(path)) return "<p>The run has not ended: there is no summary yet.</p>\n";
  std::string html = "<table>\n";
  try {
    add_rows("", Json::parse(read_file(path)), html);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", path.string(), error.what()));
  }
  return html + "</table>\n";
}

std::string page(const fs::path& run, const fs::path& folder, const std::vector<Figure>& figures) {
  std::string html = fmt::format(fmt::runtime(head), escaped(run.filename().string()));
  for (const Figure& figure : figures) {
    html += fmt::format("<h2>{}</h2>\n{}\n", escaped(figure.title), inline_svg(folder / (figure.name + ".svg")));
  }
  return html + "<h2>Summary</h2>\n" + summary_table(run) + "</body>\n</html>\n";
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(fmt::format("cannot make {}: {}", folder.string(), error.message()));
}

}  // namespace

fs::path write_report(const fs::path& run, const ReportOptions& options) {
  const fs::path folder = run / "report";
  make_folder(folder);
  std::vector<Figure> figures = gauge_figures(read_csv(run / "history.csv"), "../history.csv");
  const std::int64_t step = options.step ? *options.step : last_field_step(run);
  for (Figure& figure : crack_pictures(run, step, options, folder)) figures.push_back(std::move(figure));
  figures.push_back(energy_figure(read_csv(run / "energy.csv"), "../energy.csv"));
  for (const Figure& figure : figures) draw(figure, folder);
  fs::path html = folder / "report.html";
  write_atomically(html, page(run, folder, figures));
  return html;
}

}  // namespace ligament
