#include "build/build_walls.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "constitutive/batch_law.hpp"
#include "constitutive/tied.hpp"

namespace ligament {
namespace {

template <PointLaw Law>
Index add_law(Model& model, std::string name, Law law) {
  model.laws.push_back({std::move(name), std::make_shared<BatchLaw<Law>>(law), Law::n_history});
  return static_cast<Index>(model.laws.size() - 1);
}

Wall make_wall(const WallTable& table, Model& model) {
  Wall wall{.name = table.name};
  if (table.contact == WallContact::tied) {
    wall.bond_law = add_law(model, fmt::format("wall.{}.tie", table.name), Tied{table.friction_coefficient});
  }
  wall.contact_law = add_law(model, fmt::format("wall.{}.contact", table.name), Frictional{table.friction_coefficient});
  return wall;
}

/// The centre nearest to a wall: the wall faces its side.
Vector nearest_centre(const ParticleData& particles, const WallTable& table) {
  const Vector from = to_vector(table.from);
  const Vector along = to_vector(table.to) - from;
  const auto distance = [&](const Vector& centre) {
    const double share = std::clamp(dot(centre - from, along) / dot(along, along), 0.0, 1.0);
    return norm(centre - (from + share * along));
  };
  return *std::min_element(particles.position.begin(), particles.position.end(),
                           [&](const Vector& a, const Vector& b) { return distance(a) < distance(b); });
}

void add_nodes(const WallTable& table, const Vector& inside, Model& model) {
  Vector from = to_vector(table.from);
  Vector to = to_vector(table.to);
  // Facets have their body on the left and face what is on the right.
  if (cross(to - from, inside - from) > 0.0) std::swap(from, to);
  const auto first = static_cast<Index>(model.nodes.size());
  for (const Vector& end : {from, to}) {
    model.nodes.position.push_back(end);
    model.nodes.real_mass.push_back(0.0);
    model.nodes.id.push_back(0);
    model.nodes.free.push_back(uniform_vector(1.0));
  }
  model.facets.nodes.push_back({first, first + 1});
  model.facets.element.push_back(-1);
}

}  // namespace

void add_walls(Case& input, Model& model) {
  for (const auto& [table, view] : input.walls) {
    if (table.from == table.to) {
      input.file.add_error(input.file.position(view, "to"), fmt::format("the wall has no length {}", view.where()));
    } else if (model.particles.size() == 0) {
      input.file.add_error(
          input.file.position(view),
          fmt::format("there are no particles for the wall to touch {}: give a [[zone]]", view.where()));
    }
  }
  input.file.throw_collected_errors();
  for (const auto& [table, view] : input.walls) {
    add_nodes(table, nearest_centre(model.particles, table), model);
    model.walls.push_back(make_wall(table, model));
  }
}

}  // namespace ligament
