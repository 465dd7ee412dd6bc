#include "build/structure_pieces.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/quadrilateral.hpp"

namespace ligament {
namespace {

/// Sets of bodies that are joined (union-find); each is named by its lowest body.
class JoinedBodies {
 public:
  explicit JoinedBodies(std::size_t n_bodies) : next_(n_bodies) { std::iota(next_.begin(), next_.end(), 0); }

  std::size_t set_of(std::size_t body) {
    while (next_[body] != body) body = next_[body] = next_[next_[body]];
    return body;
  }
  void join(std::size_t a, std::size_t b) {
    a = set_of(a);
    b = set_of(b);
    next_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::size_t> sets() {
    std::vector<std::size_t> sets;
    for (std::size_t body = 0; body < next_.size(); ++body) sets.push_back(set_of(body));
    return sets;
  }

 private:
  std::vector<std::size_t> next_;  ///< a lower body of the same set; the lowest one is its own
};

bool holds(BondState bond) { return bond == BondState::bonded || bond == BondState::softening; }

/// The set of every body, particles before nodes.
std::vector<std::size_t> find_pieces(const Model& model, const State& state) {
  const std::size_t n_particles = model.particles.size();
  const auto n_facets = static_cast<Index>(model.n_element_facets());
  const auto n_nodes = static_cast<Index>(model.n_mesh_nodes());
  JoinedBodies bodies(n_particles + model.n_mesh_nodes());
  const auto node = [&](Index row) { return n_particles + static_cast<std::size_t>(row); };
  for (const auto& nodes : model.elements.nodes) {
    for (const Index other : nodes) bodies.join(node(nodes[0]), node(other));
  }
  const auto join = [&](const ContactTable& contacts, Index n_seconds, const auto& second) {
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      if (!holds(contacts.bond[row]) || contacts.second[row] >= n_seconds) continue;
      bodies.join(static_cast<std::size_t>(contacts.first[row]), second(contacts.second[row]));
    }
  };
  join(state.particle_contacts, static_cast<Index>(n_particles),
       [](Index row) { return static_cast<std::size_t>(row); });
  join(state.facet_contacts, n_facets, [&](Index row) { return node(model.facets.nodes[row][0]); });
  join(state.corner_contacts, n_nodes, node);
  return bodies.sets();
}

std::vector<double> areas_of_bodies(const Model& model) {
  std::vector<double> areas;
  for (const double radius : model.particles.radius) areas.push_back(std::numbers::pi * radius * radius);
  areas.resize(model.particles.size() + model.n_mesh_nodes(), 0.0);
  for (const auto& nodes : model.elements.nodes) {
    QuadrilateralCorners corners;
    for (std::size_t i = 0; i < nodes.size(); ++i) corners[i] = model.nodes.position[nodes[i]];
    const auto shares = quadrilateral_lumped_areas(corners);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      areas[model.particles.size() + static_cast<std::size_t>(nodes[i])] += shares[i];
    }
  }
  return areas;
}

}  // namespace

StructurePieces::StructurePieces(const Model& model, const State& state)
    : pieces_(find_pieces(model, state)), areas_(areas_of_bodies(model)) {}

double StructurePieces::largest_cut_off(const Model& model, const State& state) const {
  const std::vector<std::size_t> now = find_pieces(model, state);
  std::vector<double> area_of_piece(now.size(), 0.0);
  for (std::size_t body = 0; body < now.size(); ++body) area_of_piece[now[body]] += areas_[body];
  // Bonds only break: what is one piece now was part of one piece at first.
  std::vector<double> largest(now.size(), 0.0);
  double cut_off = 0.0;
  for (std::size_t body = 0; body < now.size(); ++body) {
    if (now[body] != body) continue;
    double& stays = largest[pieces_[body]];
    cut_off = std::max(cut_off, std::min(stays, area_of_piece[body]));
    stays = std::max(stays, area_of_piece[body]);
  }
  return cut_off / std::accumulate(areas_.begin(), areas_.end(), 0.0);
}

}  // namespace ligament
