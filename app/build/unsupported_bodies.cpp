#include "build/unsupported_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace ligament {
namespace {

/// Joins particles (first), nodes (after them) and nodes of beams (last) into bodies.
class Bodies {
 public:
  explicit Bodies(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

bool is_bonded(const ContactTable& contacts, std::size_t row) {
  return contacts.bond[row] == BondState::bonded || contacts.bond[row] == BondState::softening;
}

Bodies join_all(const Model& model, const State& state) {
  const std::size_t n_particles = model.particles.size();
  const std::size_t first_beam_node = n_particles + model.nodes.size();
  Bodies bodies(first_beam_node + model.beam_nodes.size());
  for (const auto& [i, j] : model.beam_elements.nodes) bodies.join(first_beam_node + i, first_beam_node + j);
  for (const auto& nodes : model.elements.nodes) {
    for (const Index node : nodes) bodies.join(n_particles + nodes[0], n_particles + node);
  }
  for (std::size_t row = 0; row < state.particle_contacts.size(); ++row) {
    if (!is_bonded(state.particle_contacts, row)) continue;
    bodies.join(state.particle_contacts.first[row], state.particle_contacts.second[row]);
  }
  // What a wall holds, it holds along its normal alone: see add_held_by_walls().
  const auto join_interface = [&](const ContactTable& contacts, auto&& second_node) {
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      const Index node = second_node(contacts.second[row]);
      if (!is_bonded(contacts, row) || model.wall_of_node(node) != nullptr) continue;
      bodies.join(contacts.first[row], n_particles + node);
    }
  };
  join_interface(state.facet_contacts, [&](Index facet) { return model.facets.nodes[facet][0]; });
  join_interface(state.corner_contacts, [](Index node) { return node; });
  return bodies;
}

/// The rigid motions of a body in the plane: along x, along y, rotation.
constexpr std::size_t n_motions = 3;
/// A combination of them that something forbids.
using HeldMotions = std::array<double, n_motions>;

struct Body {
  std::size_t n_particles = 0;
  std::size_t n_nodes = 0;
  std::string example;
  std::vector<HeldMotions> held;
  bool is_linked = false;  ///< to platens, which move themselves
};

using Row = std::vector<double>;

/// Number of independent rows by elimination with pivoting.
std::size_t rank(std::vector<Row> rows, std::size_t n_columns) {
  std::size_t found = 0;
  for (std::size_t column = 0; column < n_columns && found < rows.size(); ++column) {
    std::size_t pivot = found;
    for (std::size_t i = found; i < rows.size(); ++i) {
      if (std::abs(rows[i][column]) > std::abs(rows[pivot][column])) pivot = i;
    }
    if (std::abs(rows[pivot][column]) < 1e-9) continue;
    std::swap(rows[pivot], rows[found]);
    for (std::size_t i = found + 1; i < rows.size(); ++i) {
      const double factor = rows[i][column] / rows[found][column];
      if (factor == 0.0) continue;
      for (std::size_t k = column; k < n_columns; ++k) rows[i][k] -= factor * rows[found][k];
    }
    ++found;
  }
  return found;
}

std::size_t rank(const std::vector<HeldMotions>& held) {
  std::vector<Row> rows;
  for (const HeldMotions& motions : held) rows.emplace_back(motions.begin(), motions.end());
  return rank(std::move(rows), n_motions);
}

/// Positions over the size of the structure, so that the rank needs no units.
double structure_size(const Model& model) {
  double size = 0.0;
  for (const Vector& position : model.particles.position) size = std::max(size, largest_component(position));
  for (const Vector& position : model.nodes.position) size = std::max(size, largest_component(position));
  for (const Vector& position : model.beam_nodes.position) size = std::max(size, largest_component(position));
  return size > 0.0 ? size : 1.0;
}

std::string text_of(const Vector& place) {
  return fmt::format("({:.6g} m, {:.6g} m)", component(place, 0), component(place, 1));
}

bool is_hinged(const Model& model, Index own_row) {
  return std::any_of(model.platens.begin(), model.platens.end(), [own_row](const Platen& platen) {
    return platen.rotation == own_row && platen.translation != own_row;
  });
}

void add_held(const Vector& place, const Vector& free, Body& body) {
  // ω × r: the motion of a place in a rotation.
  const Vector turning = cross(Spin{1.0}, place);
  for (int axis = 0; axis < dimension; ++axis) {
    if (component(free, axis) != 0.0) continue;
    HeldMotions held{};
    held[axis] = 1.0;
    held[n_motions - 1] = component(turning, axis);
    body.held.push_back(held);
  }
}

/// What a motion along a direction at a place asks of the rigid motions of a body.
HeldMotions motion_along(const Vector& direction, const Vector& place) {
  HeldMotions motions{};
  for (int axis = 0; axis < dimension; ++axis) motions[axis] = component(direction, axis);
  motions[n_motions - 1] = cross(place, direction);
  return motions;
}

/// Two bodies that must move alike at a place along a direction.
struct Link {
  std::size_t first = 0;
  std::size_t second = 0;
  HeldMotions motions{};
};

/// All bodies by their roots, and what links them.
struct Structure {
  std::map<std::size_t, Body> bodies;
  std::vector<Link> links;
};

/// What touches a wall at set-up is held along its normal, be it by pressure alone: by the wall, or by a platen.
void add_touch(const Model& model, Index wall_node, const Vector& position, std::size_t body,
               const std::function<std::size_t(Index)>& body_of_beam_node, double size, Structure& structure) {
  const auto wall = static_cast<std::size_t>(model.wall_of_node(wall_node) - model.walls.data());
  const auto& [i, j] = model.wall_nodes(wall);
  const Vector edge = model.nodes.position[j] - model.nodes.position[i];
  const HeldMotions motions = motion_along(tangent(edge / norm(edge)), position / size);
  const Platen* platen = model.platen_of_wall(wall);
  if (platen == nullptr) {
    structure.bodies[body].held.push_back(motions);
  } else {
    structure.links.push_back({body, body_of_beam_node(platen->rotation), motions});
  }
}

Structure collect_bodies(const Model& model, const State& state) {
  Bodies joined = join_all(model, state);
  const double size = structure_size(model);
  Structure structure;
  const auto body_of_beam_node = [&](Index row) {
    return joined.find(model.particles.size() + model.nodes.size() + static_cast<std::size_t>(row));
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    Body& body = structure.bodies[joined.find(i)];
    if (body.n_particles++ == 0) body.example = fmt::format("particle {}", model.particles.id[i]);
    add_held(model.particles.position[i] / size, model.particles.free[i], body);
    if (model.particles.rotation_free[i] == 0.0) body.held.push_back({0.0, 0.0, 1.0});
  }
  for (const SetupPair& pair : model.facet_pairs) {
    const Index node = model.facets.nodes[pair.second][0];
    if (model.wall_of_node(node) == nullptr) continue;
    add_touch(model, node, model.particles.position[pair.first], joined.find(pair.first), body_of_beam_node, size,
              structure);
  }
  const ContactTable& seats = state.seat_contacts;
  for (std::size_t row = 0; row < seats.size(); ++row) {
    const Index node = seats.first[row];
    add_touch(model, model.facets.nodes[seats.second[row]][0], model.nodes.position[node],
              joined.find(model.particles.size() + node), body_of_beam_node, size, structure);
  }
  for (std::size_t i = 0; i < model.n_mesh_nodes(); ++i) {
    Body& body = structure.bodies[joined.find(model.particles.size() + i)];
    if (body.n_nodes++ == 0) body.example = fmt::format("node {}", model.nodes.id[i]);
    add_held(model.nodes.position[i] / size, model.nodes.free[i], body);
  }
  for (std::size_t i = 0; i < model.beam_nodes.size(); ++i) {
    Body& body = structure.bodies[body_of_beam_node(static_cast<Index>(i))];
    if (body.n_nodes++ == 0) body.example = fmt::format("a node at {}", text_of(model.beam_nodes.position[i]));
    if (model.beam_nodes.rotation_free[i] == 0.0) body.held.push_back({0.0, 0.0, 1.0});
    // A platen that is hinged to a beam has no translation of its own that could be held.
    if (model.beam_nodes.id[i] > 0 || !is_hinged(model, static_cast<Index>(i))) {
      add_held(model.beam_nodes.position[i] / size, model.beam_nodes.free[i], body);
    }
  }
  for (const Platen& platen : model.platens) {
    if (platen.translation == platen.rotation) continue;
    const Vector place = model.beam_nodes.position[platen.translation] / size;
    for (int axis = 0; axis < dimension; ++axis) {
      Vector direction;
      set_component(direction, axis, 1.0);
      structure.links.push_back(
          {body_of_beam_node(platen.rotation), body_of_beam_node(platen.translation), motion_along(direction, place)});
    }
  }
  for (const Link& link : structure.links) {
    for (const std::size_t body : {link.first, link.second}) structure.bodies[body].is_linked = true;
  }
  return structure;
}

/// What a list of thousands of loose particles is cut to.
constexpr std::size_t most_messages = 10;

/// The motions of the body with these columns that nothing forbids.
std::string free_motions(const std::vector<Row>& rows, std::size_t n_columns, std::size_t first_column) {
  constexpr std::array<const char*, n_motions> names{"along x", "along y", "rotation"};
  std::string text;
  const std::size_t held = rank(rows, n_columns);
  for (std::size_t motion = 0; motion < n_motions; ++motion) {
    std::vector<Row> with = rows;
    with.emplace_back(n_columns, 0.0);
    with.back()[first_column + motion] = 1.0;
    if (rank(std::move(with), n_columns) == held) continue;
    text += (text.empty() ? "" : ", ") + std::string(names[motion]);
  }
  return text;
}

/// The free motions of bodies that are held together, in words, body by body; empty for those that have none.
std::vector<std::string> free_motions(const std::vector<std::pair<std::size_t, const Body*>>& bodies,
                                      const std::vector<Link>& links) {
  const std::size_t n_columns = n_motions * bodies.size();
  std::map<std::size_t, std::size_t> first_column;
  for (std::size_t i = 0; i < bodies.size(); ++i) first_column[bodies[i].first] = n_motions * i;
  std::vector<Row> rows;
  const auto add = [&](Row& row, std::size_t root, const HeldMotions& motions, double sign) {
    // What stands by itself does not move.
    const auto column = first_column.find(root);
    if (column == first_column.end()) return;
    for (std::size_t k = 0; k < n_motions; ++k) row[column->second + k] += sign * motions[k];
  };
  for (const auto& [root, body] : bodies) {
    for (const HeldMotions& held : body->held) add(rows.emplace_back(n_columns, 0.0), root, held, 1.0);
  }
  for (const Link& link : links) {
    Row row(n_columns, 0.0);
    add(row, link.first, link.motions, 1.0);
    add(row, link.second, link.motions, -1.0);
    rows.push_back(std::move(row));
  }
  std::vector<std::string> texts(bodies.size());
  if (rank(rows, n_columns) == n_columns) return texts;
  for (std::size_t i = 0; i < bodies.size(); ++i) texts[i] = free_motions(rows, n_columns, n_motions * i);
  return texts;
}

}  // namespace

std::vector<std::string> find_unsupported_bodies(const Model& model, const State& state) {
  const Structure structure = collect_bodies(model, state);
  std::vector<std::string> messages;
  std::size_t n_unsupported = 0;
  const auto tell = [&](const Body& body, const std::string& motions) {
    if (motions.empty() || ++n_unsupported > most_messages) return;
    messages.push_back(
        fmt::format("the body of {} nodes and {} particles with {} is free to move as a whole ({}): hold it by a "
                    "[[support]]; free flight needs method = \"undamped\"",
                    body.n_nodes, body.n_particles, body.example, motions));
  };
  std::vector<std::pair<std::size_t, const Body*>> linked;
  for (const auto& [root, body] : structure.bodies) {
    if (rank(body.held) == n_motions) continue;
    if (body.is_linked) {
      linked.emplace_back(root, &body);
    } else {
      tell(body, free_motions({{root, &body}}, {}).front());
    }
  }
  const std::vector<std::string> motions = free_motions(linked, structure.links);
  for (std::size_t i = 0; i < linked.size(); ++i) tell(*linked[i].second, motions[i]);
  if (n_unsupported > most_messages) {
    messages.push_back(fmt::format("{} more bodies are free to move", n_unsupported - most_messages));
  }
  return messages;
}

}  // namespace ligament
