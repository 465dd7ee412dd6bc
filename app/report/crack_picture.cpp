#include "report/crack_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "io/csv_table.hpp"
#include "io/fields_vtkhdf.hpp"
#include "report/field_groups.hpp"
#include "report/picture.hpp"
#include "run/crack_record.hpp"

namespace ligament {
namespace {

Layer discs(const FieldCells& particles) {
  Layer layer{.name = "particles", .colour = "#a8a8a8", .width = 0.3};
  const std::vector<double> radius = particles.numbers("PointData/radius");
  for (std::size_t i = 0; i < radius.size(); ++i) layer.discs.push_back({particles.drawn[i], radius[i]});
  return layer;
}

/// Cells of so many points as closed lines.
Layer outlines(Layer layer, const FieldCells& cells, std::size_t n_corners) {
  for (std::size_t i = 0; i < cells.connectivity.size(); i += n_corners) {
    Stroke stroke;
    for (std::size_t corner = 0; corner <= n_corners; ++corner) {
      stroke.points.push_back(cells.drawn[cells.connectivity[i + corner % n_corners]]);
    }
    layer.strokes.push_back(std::move(stroke));
  }
  return layer;
}

/// Lines on planes, by mode.
struct PlaneLayers {
  Layer tension;
  Layer shear;

  void add(const CrackPlane& plane, const Vector& shift) {
    const auto ends = plane.ends();
    Layer& layer = plane.mode == FractureMode::shear ? shear : tension;
    layer.strokes.push_back({{ends[0] + shift, ends[1] + shift}, faintest + (1.0 - faintest) * plane.damage});
  }

  static constexpr double faintest = 0.15;  ///< opacity without damage
};

/// Bonds that soften, between the drawn places of their particles.
PlaneLayers softening_lines(const FieldCells& contacts, double scale) {
  const std::vector<double> kind = contacts.numbers("CellData/kind");
  const std::vector<double> bond = contacts.numbers("CellData/bond");
  const std::vector<double> mode = contacts.numbers("CellData/mode");
  const std::vector<double> length = contacts.numbers("CellData/plane_length");
  const std::vector<double> damage = contacts.numbers("CellData/damage");
  const Field<Vector> point = contacts.vectors("CellData/contact_point");
  const Field<Vector> displacement = contacts.vectors("PointData/displacement");
  PlaneLayers lines{{"softening_tension", "softening, tension", "#E08A00", 1.3, {}, {}},
                    {"softening_shear", "softening, shear", "#3A9BDC", 1.3, {}, {}}};
  for (std::size_t i = 0; i < bond.size(); ++i) {
    if (bond[i] != static_cast<double>(BondState::softening)) continue;
    const std::size_t a = contacts.connectivity[2 * i];
    const std::size_t b = contacts.connectivity[2 * i + 1];
    const Vector branch = contacts.rest[b] + displacement[b] - contacts.rest[a] - displacement[a];
    const bool is_shear = mode[i] == static_cast<double>(FractureMode::shear);
    lines.add({.centre = point[i],
               .normal = branch / norm(branch),
               .length = length[i],
               .damage = damage[i],
               .mode = is_shear ? FractureMode::shear : FractureMode::tension},
              0.5 * (scale - 1.0) * (displacement[a] + displacement[kind[i] == 0.0 ? b : a]));
  }
  return lines;
}

/// Bonds that have broken up to this step, between the drawn places of the particles at their sides.
PlaneLayers broken_lines(const std::filesystem::path& run, std::int64_t step, const FieldCells& particles) {
  std::map<double, Vector> shift_of;  // by id
  const std::vector<double> ids = particles.numbers("PointData/id");
  const Field<Vector> displacement = particles.vectors("PointData/displacement");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    shift_of[ids[i]] = particles.drawn[i] - particles.rest[i] - displacement[i];
  }
  const CsvContent table = read_csv(run / "cracks.csv");
  const std::vector<CrackPlane> planes = read_broken_planes(run / "cracks.csv", step);
  const std::vector<double> first = table.numbers("first_id");
  const std::vector<double> second = table.numbers("second_id");
  const std::size_t kind = table.column_index("kind");
  PlaneLayers lines{{"broken_tension", "broken, tension", "#C1272D", 2.0, {}, {}},
                    {"broken_shear", "broken, shear", "#0050A0", 2.0, {}, {}}};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const bool are_particles = table.rows[i][kind] == "particles";
    lines.add(planes[i], 0.5 * (shift_of[first[i]] + shift_of[are_particles ? second[i] : first[i]]));
  }
  return lines;
}

}  // namespace

std::int64_t last_field_step(const std::filesystem::path& run) {
  std::int64_t last = -1;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(run / "fields", error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".hdf") last = std::max(last, read_field_stamp(entry->path()).step);
  }
  if (last < 0) throw FileError(fmt::format("{}: there are no fields to draw", (run / "fields").string()));
  return last;
}

std::vector<Figure> crack_pictures(const std::filesystem::path& run, std::int64_t step, const ReportOptions& options,
                                   const std::filesystem::path& folder) {
  const double scale = options.scale;
  const auto particles = read_cells(run, "particles", step, scale);
  const auto elements = read_cells(run, "elements", step, scale);
  const auto walls = read_cells(run, "walls", step, scale);
  const auto contacts = read_cells(run, "contacts", step, scale);
  if (!particles && !elements) {
    throw FileError(fmt::format("{}: there are no fields of step {}", (run / "fields").string(), step));
  }
  Picture whole;
  Picture particles_alone;
  if (particles) whole.add(discs(*particles));
  particles_alone = whole;
  if (elements) whole.add(outlines({.name = "elements", .colour = "#707070", .width = 0.6}, *elements, 4));
  if (walls) whole.add(outlines({.name = "walls", .colour = "#303030", .width = 2.5}, *walls, 2));
  Layer notches{.name = "notches", .title = "notch", .colour = "#101010", .width = 2.0};
  for (const auto& [from, to] : options.notches) notches.strokes.push_back({{from, to}});
  whole.add(notches);
  particles_alone.add(std::move(notches));
  const auto add_planes = [&](const PlaneLayers& lines) {
    for (Picture* picture : {&whole, &particles_alone}) {
      picture->add(lines.tension);
      picture->add(lines.shear);
    }
  };
  if (contacts) add_planes(softening_lines(*contacts, scale));
  if (particles) add_planes(broken_lines(run, step, *particles));
  const std::string title = fmt::format("Cracks at step {}, displacements times {}", step, scale);
  std::vector<Figure> figures{whole.figure("cracks", title, folder)};
  if (particles && elements) figures.push_back(particles_alone.figure("cracks_close", "The particles alone", folder));
  return figures;
}

}  // namespace ligament
