#include "ensemble/ensemble_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/mean_curve.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "report/ensemble_figure.hpp"
#include "report/load_curves.hpp"

namespace ligament {
namespace {

namespace fs = std::filesystem;

/// choice: finer than the rows of most runs, so that the mean shows their drops.
constexpr std::size_t n_points = 401;

/// The curves of a group, and the columns that they are of.
struct GroupCurves {
  std::string abscissa;
  std::string load;
  std::vector<std::string> tables;  ///< history.csv of every run, within the folder of the ensemble
  std::vector<Curve> curves;        ///< with an abscissa that grows, see direction
  double direction = 1.0;           ///< -1 if the abscissa becomes more and more negative
};

/// 1 if the columns go farther up than down, else -1.
double direction_of(const std::vector<CsvContent>& histories, const std::string& column) {
  double lowest = 0.0;
  double highest = 0.0;
  for (const CsvContent& history : histories) {
    for (const double value : history.numbers(column)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  return highest >= -lowest ? 1.0 : -1.0;
}

GroupCurves curves_of(const fs::path& folder, const std::vector<EnsembleRow>& rows) {
  GroupCurves group;
  std::vector<CsvContent> histories;
  for (const EnsembleRow& row : rows) {
    if (!row.outcome.is_done()) continue;
    group.tables.push_back(row.member.run + "/history.csv");
    histories.push_back(read_csv(folder / group.tables.back()));
  }
  if (histories.empty()) return group;
  const LoadCurves columns = load_curves(histories.front());
  if (columns.displacements.empty()) return group;
  group.abscissa = columns.displacements.front();
  group.load = columns.load;
  group.direction = direction_of(histories, group.abscissa);
  for (const CsvContent& history : histories) {
    std::vector<double> x = history.numbers(group.abscissa);
    for (double& value : x) value *= group.direction;
    group.curves.push_back(forward_part(x, history.numbers(group.load)));
  }
  return group;
}

std::string table_of(const GroupCurves& group, const std::vector<BandPoint>& band) {
  std::string text = fmt::format("{},mean_{},lower_{},upper_{},standard_deviation_{},n_runs\n", group.abscissa,
                                 group.load, group.load, group.load, group.load);
  for (const auto& [x, y] : band) {
    text += fmt::format("{},{},{},{},{},{}\n", group.direction * x, y.mean, y.min, y.max, y.standard_deviation, y.n);
  }
  return text;
}

}  // namespace

bool write_ensemble_curves(const fs::path& folder, const std::vector<EnsembleRow>& rows) {
  EnsemblePicture picture;
  for (const std::vector<EnsembleRow>& group : groups_of(rows)) {
    const GroupCurves curves = curves_of(folder, group);
    const std::vector<BandPoint> band = band_of(curves.curves, n_points);
    if (band.empty()) continue;
    const std::string& name = group.front().member.group;
    const std::string table = name.empty() ? "curve.csv" : name + "/curve.csv";
    write_atomically(folder / table, table_of(curves, band));
    picture.abscissa = curves.abscissa;
    picture.load = curves.load;
    picture.groups.push_back({name.empty() ? "mean" : name, table, curves.tables});
    picture.largest_x = std::max({picture.largest_x, std::abs(band.front().abscissa), std::abs(band.back().abscissa)});
    for (const BandPoint& point : band) {
      picture.largest_y = std::max({picture.largest_y, std::abs(point.ordinate.min), std::abs(point.ordinate.max)});
    }
  }
  if (picture.groups.empty()) return false;
  draw(ensemble_figure(picture), folder);
  return true;
}

}  // namespace ligament
