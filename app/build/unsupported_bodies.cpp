#include "build/unsupported_bodies.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace ligament {
namespace {

/// Joins particles (first) and nodes (after them) into bodies.
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
  Bodies bodies(n_particles + model.nodes.size());
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

/// The rigid motions of a body in the plane: along x, along y, rotation. A held freedom forbids a combination of them.
constexpr std::size_t n_motions = 3;
using HeldMotions = std::array<double, n_motions>;

struct Body {
  std::size_t n_particles = 0;
  std::size_t n_nodes = 0;
  std::string example;
  std::vector<HeldMotions> held;
};

/// Number of independent rows by elimination with pivoting.
std::size_t rank(std::vector<HeldMotions> rows) {
  std::size_t found = 0;
  for (std::size_t column = 0; column < n_motions && found < rows.size(); ++column) {
    std::size_t pivot = found;
    for (std::size_t i = found; i < rows.size(); ++i) {
      if (std::abs(rows[i][column]) > std::abs(rows[pivot][column])) pivot = i;
    }
    if (std::abs(rows[pivot][column]) < 1e-9) continue;
    std::swap(rows[pivot], rows[found]);
    for (std::size_t i = found + 1; i < rows.size(); ++i) {
      const double factor = rows[i][column] / rows[found][column];
      for (std::size_t k = column; k < n_motions; ++k) rows[i][k] -= factor * rows[found][k];
    }
    ++found;
  }
  return found;
}

/// Positions over the size of the structure, so that the rank needs no units.
double structure_size(const Model& model) {
  double size = 0.0;
  for (const Vector& position : model.particles.position) size = std::max(size, largest_component(position));
  for (const Vector& position : model.nodes.position) size = std::max(size, largest_component(position));
  return size > 0.0 ? size : 1.0;
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

/// A wall holds a particle that touches it at set-up along its normal, be it by pressure alone.
void add_held_by_wall(const Model& model, const SetupPair& pair, double size, Body& body) {
  const auto& [i, j] = model.facets.nodes[pair.second];
  const Vector edge = model.nodes.position[j] - model.nodes.position[i];
  const Vector normal = tangent(edge / norm(edge));
  body.held.push_back({normal.x, normal.y, cross(model.particles.position[pair.first] / size, normal)});
}

std::map<std::size_t, Body> collect_bodies(const Model& model, const State& state) {
  Bodies joined = join_all(model, state);
  const double size = structure_size(model);
  std::map<std::size_t, Body> bodies;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    Body& body = bodies[joined.find(i)];
    if (body.n_particles++ == 0) body.example = fmt::format("particle {}", model.particles.id[i]);
    add_held(model.particles.position[i] / size, model.particles.free[i], body);
    if (model.particles.rotation_free[i] == 0.0) body.held.push_back({0.0, 0.0, 1.0});
  }
  for (const SetupPair& pair : model.facet_pairs) {
    if (model.wall_of_node(model.facets.nodes[pair.second][0]) == nullptr) continue;
    add_held_by_wall(model, pair, size, bodies[joined.find(pair.first)]);
  }
  for (std::size_t i = 0; i < model.n_mesh_nodes(); ++i) {
    Body& body = bodies[joined.find(model.particles.size() + i)];
    if (body.n_nodes++ == 0) body.example = fmt::format("node {}", model.nodes.id[i]);
    add_held(model.nodes.position[i] / size, model.nodes.free[i], body);
  }
  return bodies;
}

/// What a list of thousands of loose particles is cut to.
constexpr std::size_t most_messages = 10;

/// The motions that none of the supports, alone or together, forbid.
std::string free_motions(const Body& body) {
  constexpr std::array<const char*, n_motions> names{"along x", "along y", "rotation"};
  std::string text;
  for (std::size_t motion = 0; motion < n_motions; ++motion) {
    std::vector<HeldMotions> with = body.held;
    with.push_back({});
    with.back()[motion] = 1.0;
    if (rank(with) == rank(body.held)) continue;
    text += (text.empty() ? "" : ", ") + std::string(names[motion]);
  }
  return text;
}

}  // namespace

std::vector<std::string> find_unsupported_bodies(const Model& model, const State& state) {
  std::vector<std::string> messages;
  std::size_t n_unsupported = 0;
  for (const auto& [root, body] : collect_bodies(model, state)) {
    if (rank(body.held) == n_motions || ++n_unsupported > most_messages) continue;
    messages.push_back(
        fmt::format("the body of {} nodes and {} particles with {} is free to move as a whole ({}): hold it by a "
                    "[[support]]; free flight needs method = \"undamped\"",
                    body.n_nodes, body.n_particles, body.example, free_motions(body)));
  }
  if (n_unsupported > most_messages) {
    messages.push_back(fmt::format("{} more bodies are free to move", n_unsupported - most_messages));
  }
  return messages;
}

}  // namespace ligament
