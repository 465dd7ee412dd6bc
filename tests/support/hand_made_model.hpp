#pragma once

#include <memory>
#include <numbers>

#include "constitutive/batch_law.hpp"
#include "constitutive/frictional.hpp"
#include "constitutive/linear_elastic.hpp"
#include "constitutive/tied.hpp"
#include "core/model.hpp"

/// Models put together body by body, with round numbers.
namespace ligament::support {

struct ModelChoice {
  double young_modulus = 1e9;  ///< (Pa)
  double poisson_ratio = 0.2;
  double density = 2000.0;  ///< (kg/m3)
  double friction_coefficient = 0.3;
  double thickness = 1.0;       ///< (m)
  double detection_gap = 1e-6;  ///< of the one zone
  double interface_gap = 0.5;   ///< of the one zone
  StiffnessFormula stiffness = StiffnessFormula::plane;
  ContactLength contact_length = ContactLength::centre_distance;
};

inline constexpr Index bond_law = 0;
inline constexpr Index contact_law = 1;

/// No bodies yet; one zone, one material with elastic bonds, frictional contacts without bond.
inline Model empty_model(const ModelChoice& choice = {}) {
  Model model;
  model.thickness = choice.thickness;
  model.materials.push_back({.name = "rock",
                             .young_modulus = choice.young_modulus,
                             .poisson_ratio = choice.poisson_ratio,
                             .density = choice.density,
                             .stiffness = choice.stiffness,
                             .contact_length = choice.contact_length,
                             .bond_law = bond_law,
                             .contact_law = contact_law});
  model.zones.push_back({.name = "all",
                         .interface_material = 0,
                         .detection_gap = choice.detection_gap,
                         .interface_gap = choice.interface_gap});
  model.laws.push_back(
      {"rock.bond", std::make_shared<BatchLaw<LinearElastic>>(LinearElastic{choice.friction_coefficient}), 0});
  model.laws.push_back(
      {"rock.contact", std::make_shared<BatchLaw<Frictional>>(Frictional{choice.friction_coefficient}), 1});
  return model;
}

/// A free disc with the mass ρ π R² t; returns its row.
inline Index add_particle(Model& model, const Vector& position, double radius) {
  ParticleData& particles = model.particles;
  particles.position.push_back(position);
  particles.radius.push_back(radius);
  particles.real_mass.push_back(model.materials[0].density * std::numbers::pi * radius * radius * model.thickness);
  particles.material.push_back(0);
  particles.zone.push_back(0);
  particles.id.push_back(static_cast<Index>(particles.size()));
  particles.free.push_back(uniform_vector(1.0));
  particles.rotation_free.push_back(1.0);
  return static_cast<Index>(particles.size() - 1);
}

/// A free node of unit mass; returns its row.
inline Index add_node(Model& model, const Vector& position) {
  model.nodes.position.push_back(position);
  model.nodes.real_mass.push_back(1.0);
  model.nodes.id.push_back(static_cast<Index>(model.nodes.size()));
  model.nodes.free.push_back(uniform_vector(1.0));
  return static_cast<Index>(model.nodes.size() - 1);
}

/// A facet i→j, solid on its left; returns its row.
inline Index add_facet(Model& model, Index i, Index j) {
  model.facets.nodes.push_back({i, j});
  model.facets.element.push_back(0);
  return static_cast<Index>(model.facets.size() - 1);
}

/// How a wall touches particles.
struct WallChoice {
  double friction_coefficient = 0.0;
  bool is_tied = false;
};

/// A wall that faces what is on the right of its way; walls come after all other nodes and facets. Returns its row.
inline std::size_t add_wall(Model& model, const Vector& from, const Vector& to, const WallChoice& choice = {}) {
  Wall wall{.name = "wall"};
  if (choice.is_tied) {
    wall.bond_law = static_cast<Index>(model.laws.size());
    model.laws.push_back({"wall.tie", std::make_shared<BatchLaw<Tied>>(), 0});
  }
  wall.contact_law = static_cast<Index>(model.laws.size());
  model.laws.push_back(
      {"wall.contact", std::make_shared<BatchLaw<Frictional>>(Frictional{choice.friction_coefficient}), 1});
  const Index first = add_node(model, from);
  const Index second = add_node(model, to);
  for (const Index node : {first, second}) {
    model.nodes.real_mass[node] = 0.0;
    model.nodes.id[node] = 0;
  }
  add_facet(model, first, second);
  model.facets.element.back() = -1;
  model.walls.push_back(wall);
  return model.walls.size() - 1;
}

/// A closed outline of a solid, corners counter-clockwise, one facet from each to the next.
inline void add_outline(Model& model, const std::vector<Vector>& corners) {
  const auto first = static_cast<Index>(model.nodes.size());
  const auto count = static_cast<Index>(corners.size());
  for (const Vector& corner : corners) add_node(model, corner);
  for (Index i = 0; i < count; ++i) add_facet(model, first + i, first + (i + 1) % count);
}

}  // namespace ligament::support
