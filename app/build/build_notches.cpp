#include "build/build_notches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "build/generate_packings.hpp"
#include "build/notched_elements.hpp"
#include "contact/cut_pairs.hpp"

namespace ligament {
namespace {

std::vector<Rectangle> zones_of(const Case& input) {
  std::vector<Rectangle> zones;
  for (const auto& zone : input.zones) zones.push_back(rectangle_of(zone.table));
  return zones;
}

void check_elements(Case& input, const Notch& notch, const TableView& view) {
  const MeshTable& mesh = input.mesh->table;
  const NotchedElements found = notched_elements(notch, {mesh.x, mesh.y}, zones_of(input));
  if (notch.width == 0.0 && (found.cuts_into_one || found.parts_two)) {
    input.file.add_error(
        input.file.position(view),
        fmt::format("a notch without width cannot part elements {}: give it a 'width', or let particles take their "
                    "place",
                    view.where()));
  } else if (found.cuts_into_one) {
    input.file.add_error(
        input.file.position(view),
        fmt::format("the notch cuts into elements {}: its sides must follow lines of the mesh", view.where()));
  }
}

}  // namespace

std::vector<Notch> build_notches(Case& input) {
  std::vector<Notch> notches;
  for (const auto& [table, view] : input.notches) {
    if (table.from == table.to) {
      input.file.add_error(input.file.position(view, "to"), fmt::format("the notch has no length {}", view.where()));
      continue;
    }
    notches.push_back({.name = table.name,
                       .from = to_vector(table.from),
                       .to = to_vector(table.to),
                       .width = table.width,
                       .gap = table.gap});
    if (input.mesh) check_elements(input, notches.back(), view);
  }
  input.file.throw_collected_errors();
  return notches;
}

std::vector<Rectangle> take_elements(const Case& input, std::vector<Notch>& notches) {
  std::vector<Rectangle> taken;
  const MeshTable& mesh = input.mesh->table;
  for (Notch& notch : notches) {
    const std::vector<Rectangle> more = notched_elements(notch, {mesh.x, mesh.y}, zones_of(input)).taken;
    notch.n_taken += more.size();
    taken.insert(taken.end(), more.begin(), more.end());
  }
  return taken;
}

void refuse_idle_notches(Case& input, const Model& model) {
  for (std::size_t i = 0; i < model.notches.size(); ++i) {
    const Notch& notch = model.notches[i];
    if (notch.n_taken > 0 || cuts_pairs(model, notch)) continue;
    const TableView& view = input.notches[i].view;
    input.file.add_error(input.file.position(view), fmt::format("the notch has nothing to cut {}", view.where()));
  }
  input.file.throw_collected_errors();
}

}  // namespace ligament
