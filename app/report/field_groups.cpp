#include "report/field_groups.hpp"

#include <fmt/format.h>

#include "io/field_series.hpp"
#include "io/fields_vtkhdf.hpp"

namespace ligament {

std::vector<double> FieldCells::numbers(const char* name) const { return read_field_array(path, name); }

Field<Vector> FieldCells::vectors(const char* name) const {
  const std::vector<double> flat = read_field_array(path, name);
  constexpr std::size_t n_space = 3;
  Field<Vector> values(flat.size() / n_space);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int axis = 0; axis < dimension; ++axis) {
      set_component(values[i], axis, flat[n_space * i + static_cast<std::size_t>(axis)]);
    }
  }
  return values;
}

std::optional<FieldCells> read_cells(const std::filesystem::path& run, const char* group, std::int64_t step,
                                     double scale) {
  FieldCells cells{.path = FieldSeries(run / "fields", group).file_of(step)};
  if (!std::filesystem::exists(cells.path)) return {};
  cells.rest = cells.vectors("Points");
  cells.drawn = cells.rest;
  const Field<Vector> displacement = cells.vectors("PointData/displacement");
  for (std::size_t i = 0; i < cells.drawn.size(); ++i) cells.drawn[i] += scale * displacement[i];
  for (const double point : cells.numbers("Connectivity")) {
    cells.connectivity.push_back(static_cast<std::size_t>(point));
  }
  return cells;
}

}  // namespace ligament
