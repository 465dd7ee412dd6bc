#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"
#include "reference/freedoms.hpp"

/// The stiffness of all contacts and elements in one sparse matrix: the slow and obvious twin of the forces that a step
/// adds up. It shares no code with them.
namespace ligament::reference {

/// How much one freedom moves a spring.
struct SpringTerm {
  Eigen::Index freedom;
  double factor;
};

using Spring = std::vector<SpringTerm>;
using Triplets = std::vector<Eigen::Triplet<double>>;

inline void add_spring(const Spring& spring, double stiffness, Triplets& triplets) {
  for (const SpringTerm& a : spring) {
    for (const SpringTerm& b : spring) triplets.emplace_back(a.freedom, b.freedom, stiffness * a.factor * b.factor);
  }
}

/// A contact in its own frame: unit normal from the particle to the other body, arms to the contact point.
struct ContactFrame {
  Eigen::Index particle = 0;
  Vector normal;
  double arm = 0.0;
};

/// A point of the second body that the two springs of a contact hold on to.
struct SpringEnd {
  Eigen::Index x = 0;  ///< freedom along x
  Eigen::Index y = 0;
  double share = 1.0;
};

/// Eq. (29): normal spring n·(u_B - u_A), shear spring t·(u_B - u_A) - r_A θ_A - r_B θ_B. `rotation` holds the term of
/// θ_B, if any.
inline void add_contact(const Freedoms& freedoms, const ContactFrame& frame, const std::vector<SpringEnd>& ends,
                        const Spring& rotation, double normal_stiffness, double shear_stiffness, Triplets& triplets) {
  const auto spring_along = [&](const Vector& direction) {
    Spring spring{{freedoms.particle(frame.particle, 0), -direction.x},
                  {freedoms.particle(frame.particle, 1), -direction.y}};
    for (const SpringEnd& end : ends) {
      spring.push_back({end.x, end.share * direction.x});
      spring.push_back({end.y, end.share * direction.y});
    }
    return spring;
  };
  Spring shear = spring_along({-frame.normal.y, frame.normal.x});
  shear.push_back({freedoms.rotation(frame.particle), -frame.arm});
  shear.insert(shear.end(), rotation.begin(), rotation.end());
  add_spring(spring_along(frame.normal), normal_stiffness, triplets);
  add_spring(shear, shear_stiffness, triplets);
}

/// Bonds that hold, and contacts without bond that press.
inline bool is_active(const ContactTable& contacts, std::size_t row) {
  const BondState bond = contacts.bond[row];
  return bond == BondState::bonded || bond == BondState::softening || contacts.normal_force[row] > 0.0;
}

inline void add_particle_contacts(const Model& model, const State& state, Triplets& triplets) {
  const Freedoms freedoms(model);
  const ContactTable& contacts = state.particle_contacts;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (!is_active(contacts, row)) continue;
    const Index a = contacts.first[row];
    const Index b = contacts.second[row];
    const auto place = [&](Index i) {
      return model.particles.position[i] + state.particles.translation.displacement[i];
    };
    const double distance = norm(place(b) - place(a));
    const double overlap = model.particles.radius[a] + model.particles.radius[b] - distance;
    add_contact(freedoms, {a, (place(b) - place(a)) / distance, model.particles.radius[a] - 0.5 * overlap},
                {{freedoms.particle(b, 0), freedoms.particle(b, 1), 1.0}},
                {{freedoms.rotation(b), -(model.particles.radius[b] - 0.5 * overlap)}}, contacts.normal_stiffness[row],
                contacts.shear_stiffness[row], triplets);
  }
}

inline void add_facet_contacts(const Model& model, const State& state, Triplets& triplets) {
  const Freedoms freedoms(model);
  const ContactTable& contacts = state.facet_contacts;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (!is_active(contacts, row)) continue;
    const Index a = contacts.first[row];
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    const Vector node_i = model.nodes.position[i] + state.nodes.translation.displacement[i];
    const Vector node_j = model.nodes.position[j] + state.nodes.translation.displacement[j];
    const Vector centre = model.particles.position[a] + state.particles.translation.displacement[a];
    const Vector axial = (node_j - node_i) / norm(node_j - node_i);
    const double share = dot(centre - node_i, axial) / norm(node_j - node_i);
    const Vector arm = node_i + share * (node_j - node_i) - centre;
    add_contact(
        freedoms, {a, {-axial.y, axial.x}, norm(arm)},
        {{freedoms.node(i, 0), freedoms.node(i, 1), 1.0 - share}, {freedoms.node(j, 0), freedoms.node(j, 1), share}},
        {}, contacts.normal_stiffness[row], contacts.shear_stiffness[row], triplets);
  }
}

inline void add_corner_contacts(const Model& model, const State& state, Triplets& triplets) {
  const Freedoms freedoms(model);
  const ContactTable& contacts = state.corner_contacts;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (!is_active(contacts, row)) continue;
    const Index a = contacts.first[row];
    const Index node = contacts.second[row];
    const Vector arm = model.nodes.position[node] + state.nodes.translation.displacement[node] -
                       (model.particles.position[a] + state.particles.translation.displacement[a]);
    add_contact(freedoms, {a, arm / norm(arm), norm(arm)}, {{freedoms.node(node, 0), freedoms.node(node, 1), 1.0}}, {},
                contacts.normal_stiffness[row], contacts.shear_stiffness[row], triplets);
  }
}

inline void add_elements(const Model& model, Triplets& triplets) {
  const Freedoms freedoms(model);
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const auto& nodes = model.elements.nodes[element];
    const auto freedom = [&](std::size_t k) { return freedoms.node(nodes[k / 2], static_cast<int>(k % 2)); };
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        triplets.emplace_back(freedom(i), freedom(j), model.elements.stiffness[element][8 * i + j]);
      }
    }
  }
}

/// K of all freedoms, prescribed ones included, about the configuration of the state.
inline Eigen::SparseMatrix<double> assemble_stiffness(const Model& model, const State& state) {
  Triplets triplets;
  add_particle_contacts(model, state, triplets);
  add_facet_contacts(model, state, triplets);
  add_corner_contacts(model, state, triplets);
  add_elements(model, triplets);
  const Freedoms freedoms(model);
  Eigen::SparseMatrix<double> stiffness(freedoms.count(), freedoms.count());
  stiffness.setFromTriplets(triplets.begin(), triplets.end());
  return stiffness;
}

}  // namespace ligament::reference
