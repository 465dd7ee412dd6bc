#include "build/build_beams.hpp"

#include <fmt/format.h>

#include "build/build_model.hpp"

namespace ligament {
namespace {

std::vector<Vector> places_of(Case& input, const BeamTable& table, const TableView& view) {
  std::vector<Vector> places;
  if (table.x.size() != table.y.size()) {
    input.file.add_error(input.file.position(view, "y"),
                         fmt::format("'y' has {} positions and 'x' has {} {}: every node needs both", table.y.size(),
                                     table.x.size(), view.where()));
    return places;
  }
  for (std::size_t i = 0; i < table.x.size(); ++i) {
    const Vector place = to_vector({table.x[i], table.y[i]});
    if (!places.empty() && place == places.back()) {
      input.file.add_error(input.file.position(view, "x"),
                           fmt::format("nodes {} and {} are at the same place {}", i, i + 1, view.where()));
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace

void add_beams(Case& input, Model& model) {
  for (const auto& [table, view] : input.beams) {
    const std::vector<Vector> places = places_of(input, table, view);
    input.file.throw_collected_errors();
    const Material& material = model.materials[material_row(model, table.material)];
    const BeamSection section{.young_modulus = material.young_modulus,
                              .poisson_ratio = material.poisson_ratio,
                              .density = material.density,
                              .depth = table.depth,
                              .width = table.width,
                              .theory = table.theory};
    add_beam(table.name, places, section, model);
  }
}

}  // namespace ligament
