#include "build/build_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "build/select_bodies.hpp"
#include "constitutive/batch_law.hpp"
#include "constitutive/tied.hpp"
#include "mesh/beam_properties.hpp"
#include "mesh/element_properties.hpp"

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

/// The middle of the particle or element nearest to a wall: the wall faces its side.
Vector nearest_middle(const Model& model, const WallTable& table) {
  const Vector from = to_vector(table.from);
  const Vector along = to_vector(table.to) - from;
  double least = std::numeric_limits<double>::infinity();
  Vector nearest;
  const auto see = [&](const Vector& middle) {
    const double share = std::clamp(dot(middle - from, along) / dot(along, along), 0.0, 1.0);
    const double distance = norm(middle - (from + share * along));
    if (distance >= least) return;
    least = distance;
    nearest = middle;
  };
  for (const Vector& centre : model.particles.position) see(centre);
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    Vector sum;
    for (const Vector& corner : corners_of(model, element)) sum += corner;
    see(0.25 * sum);
  }
  return nearest;
}

void add_nodes(const WallTable& table, const Vector& inside, Model& model) {
  // The ends of platens follow their middle.
  const Vector free = uniform_vector(table.driven_by == WallDrive::force ? 0.0 : 1.0);
  Vector from = to_vector(table.from);
  Vector to = to_vector(table.to);
  // Facets have their body on the left and face what is on the right.
  if (cross(to - from, inside - from) > 0.0) std::swap(from, to);
  const auto first = static_cast<Index>(model.nodes.size());
  for (const Vector& end : {from, to}) {
    model.nodes.position.push_back(end);
    model.nodes.real_mass.push_back(0.0);
    model.nodes.id.push_back(0);
    model.nodes.free.push_back(free);
  }
  model.facets.nodes.push_back({first, first + 1});
  model.facets.element.push_back(-1);
}

/// The node of a beam at a place; -1 if there is none.
Index beam_node_at(const Model& model, const Beam& beam, const Vector& place, double tolerance) {
  for (Index row = beam.first_node; row < beam.first_node + beam.n_nodes; ++row) {
    if (norm(model.beam_nodes.position[row] - place) <= tolerance) return row;
  }
  return -1;
}

/// Its middle turns by itself; it translates by itself, too, or with the node of a beam.
void add_platen(Case& input, const WallTable& table, const TableView& view, Model& model) {
  const Vector from = to_vector(table.from);
  const Vector to = to_vector(table.to);
  const double half = 0.5 * norm(to - from);
  const Vector middle = 0.5 * (from + to);
  const Index own = add_beam_node(middle, half, 0, model.beam_nodes);
  Platen platen{static_cast<Index>(model.walls.size() - 1), own, own};
  if (table.beam) {
    const Beam* beam = find_beam(model, *table.beam, input.file, view, "beam");
    if (beam == nullptr) return;
    platen.translation = beam_node_at(model, *beam, middle, 1e-6 * half);
    if (platen.translation < 0) {
      input.file.add_error(input.file.position(view, "beam"),
                           fmt::format("beam '{}' has no node at the middle of the wall, ({:.9g} m, {:.9g} m) {}",
                                       beam->name, component(middle, 0), component(middle, 1), view.where()));
      return;
    }
    model.beam_nodes.free[own] = Vector{};
  }
  const double mass = table.mass.value_or(0.0);
  model.beam_nodes.real_mass[platen.translation] += mass;
  model.beam_nodes.real_inertia[own] = mass * half * half / 3.0;
  model.platens.push_back(platen);
}

void check_wall(Case& input, const WallTable& table, const TableView& view) {
  const auto refuse = [&](const char* key, const std::string& text) {
    input.file.add_error(input.file.position(view, key), fmt::format("{} {}", text, view.where()));
  };
  const bool is_platen = table.driven_by == WallDrive::force;
  if (table.from == table.to) refuse("to", "the wall has no length");
  if (table.beam && !is_platen) refuse("beam", "a wall that rests on a beam needs driven_by = \"force\"");
  if (table.mass && !is_platen) refuse("mass", "the mass of a wall counts with driven_by = \"force\" alone");
  if (is_platen && !table.mass && input.solver.time_step.masses == Masses::real) {
    refuse("driven_by", "missing key 'mass': masses = \"real\" needs that of a wall that is driven by force");
  }
}

}  // namespace

void add_walls(Case& input, Model& model) {
  for (const auto& [table, view] : input.walls) check_wall(input, table, view);
  input.file.throw_collected_errors();
  for (const auto& [table, view] : input.walls) {
    add_nodes(table, nearest_middle(model, table), model);
    model.walls.push_back(make_wall(table, model));
    if (table.driven_by == WallDrive::force) add_platen(input, table, view, model);
  }
}

void refuse_idle_walls(Case& input, const Model& model, const State& state) {
  if (model.particles.size() > 0) return;
  for (std::size_t wall = 0; wall < model.walls.size(); ++wall) {
    const auto facet = static_cast<Index>(model.n_element_facets() + wall);
    const Field<Index>& facets = state.seat_contacts.second;
    if (std::find(facets.begin(), facets.end(), facet) != facets.end()) continue;
    const TableView& view = input.walls[wall].view;
    input.file.add_error(
        input.file.position(view),
        fmt::format("there are no particles, and no nodes of elements on it, for the wall to touch {}", view.where()));
  }
  input.file.throw_collected_errors();
}

}  // namespace ligament
