#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/constitutive_law.hpp"
#include "core/notch.hpp"
#include "core/vector.hpp"

/// What does not change during a run: geometry at rest, connectivity, properties. Everything that changes is in State.
namespace ligament {

/// Rigid discs, numbered in spatial order; `id` is the permanent number used in output and messages.
struct ParticleData {
  Field<Vector> position;       ///< centre at rest (m)
  Field<double> radius;         ///< R (m)
  Field<double> real_mass;      ///< its share of ρ · area · t of the zone (kg)
  Field<Index> material;        ///< row of Model::materials
  Field<Index> zone;            ///< row of Model::zones
  Field<Index> id;              ///< counted from 1
  Field<Vector> free;           ///< 1 where the centre is free to move along an axis, 0 where its motion is prescribed
  Field<double> rotation_free;  ///< likewise for the rotation

  [[nodiscard]] std::size_t size() const { return radius.size(); }
};

/// Nodes of finite elements: translations only.
struct NodeData {
  Field<Vector> position;   ///< at rest (m)
  Field<double> real_mass;  ///< lumped by row sums; 0 at the ends of walls (kg)
  Field<Index> id;          ///< number in the full grid, counted from 1; 0 at the ends of walls
  Field<Vector> free;       ///< see ParticleData::free

  [[nodiscard]] std::size_t size() const { return position.size(); }
};

/// K of one element, dofs (node 0: x, y; node 1: x, y; …), row by row (N/m).
using ElementStiffness = std::array<double, 64>;

/// 4-node quadrilaterals, nodes counter-clockwise.
struct ElementData {
  Field<std::array<Index, 4>> nodes;
  Field<ElementStiffness> stiffness;
  Field<Index> material;
  Field<Index> id;  ///< number in the full grid, counted from 1

  [[nodiscard]] std::size_t size() const { return nodes.size(); }
};

/// Boundary pieces of the elements (edges i→j, the element on their left), found by the mesh itself.
struct FacetData {
  Field<std::array<Index, 2>> nodes;
  Field<Index> element;

  [[nodiscard]] std::size_t size() const { return nodes.size(); }
};

/// Nodes of beams, beam by beam, and the middles of platens after them.
struct BeamNodeData {
  Field<Vector> position;       ///< at rest (m)
  Field<double> real_mass;      ///< lumped (kg)
  Field<double> real_inertia;   ///< lumped (kg m2)
  Field<double> lever;          ///< l: rotations are measured as l θ where they stand beside translations (m)
  Field<Index> id;              ///< number along its beam, counted from 1; 0 for the middles of platens
  Field<Vector> free;           ///< see ParticleData::free
  Field<double> rotation_free;  ///< likewise

  [[nodiscard]] std::size_t size() const { return position.size(); }
};

/// 2-node beam elements of small deflection, each as the three springs that its stiffness consists of; see
/// beam_springs.
struct BeamElementData {
  Field<std::array<Index, 2>> nodes;  ///< rows of Model::beam_nodes
  Field<double> axial;                ///< E A / L (N/m)
  Field<double> bending;              ///< E I / L, of a constant moment (N m)
  Field<double> shear;                ///< 12 E I / (L³ (1 + Φ)), of a constant shear force (N/m)

  [[nodiscard]] std::size_t size() const { return nodes.size(); }
};

/// A row of beam elements from node to node.
struct Beam {
  std::string name;
  Index first_node = 0;  ///< row of Model::beam_nodes
  Index n_nodes = 0;
};

/// A contact law bound to the material whose contacts it serves.
struct LawBinding {
  std::string name;  ///< "<material>.bond" or "<material>.contact"
  std::shared_ptr<const ConstitutiveLaw> law;
  std::size_t n_history = 0;  ///< number of its history variables
};

/// How the stiffness of a contact follows from the elastic constants of the continuum.
enum class StiffnessFormula { plane, hexagonal };

/// Which length enters Eq. (33).
enum class ContactLength { centre_distance, radius_sum };

enum class PlaneState { stress, strain };

/// Elastic constants and the contact laws of a named material.
struct Material {
  std::string name;
  double young_modulus = 0.0;  ///< E (Pa)
  double poisson_ratio = 0.0;  ///< ν
  double density = 0.0;        ///< ρ (kg/m3); 0 where the case gives none
  StiffnessFormula stiffness = StiffnessFormula::plane;
  ContactLength contact_length = ContactLength::centre_distance;
  Index bond_law = -1;     ///< row of Model::laws for pairs bonded at set-up
  Index contact_law = -1;  ///< row of Model::laws for all other pairs
};

/// A region filled with particles.
struct Zone {
  std::string name;
  Index interface_material = 0;  ///< material of the contacts between its particles and element facets
  double detection_gap = 0.0;    ///< particles closer than this times the sum of their radii are bonded at set-up
  double interface_gap = 0.0;    ///< particles closer to a facet than this times their radius are bonded to it
};

/// Two bodies that touched, or were bonded, at set-up, first < second in their own tables.
struct SetupPair {
  Index first = 0;
  Index second = 0;
  friend auto operator<=>(const SetupPair&, const SetupPair&) = default;
};

/// A rigid segment whose motion is prescribed, or that forces move if it is a platen: a facet without an element. Its
/// two end nodes follow those of the mesh in Model::nodes, its facet those of the elements in Model::facets, wall by
/// wall.
struct Wall {
  std::string name;
  Index bond_law = -1;     ///< row of Model::laws for particles tied to it at set-up; -1 if it ties none
  Index contact_law = -1;  ///< row of Model::laws for all other particles
};

/// A wall that is moved by forces: its ends follow its middle as a rigid segment does. Where a beam rests on it, the
/// middle translates as the node of the beam does, and turns by itself: a hinge.
struct Platen {
  Index wall = 0;         ///< row of Model::walls
  Index translation = 0;  ///< row of Model::beam_nodes that it translates with
  Index rotation = 0;     ///< row of Model::beam_nodes that it turns with, its own
};

struct Model {
  double thickness = 1.0;  ///< t (m)
  PlaneState plane = PlaneState::stress;
  std::vector<Material> materials;
  std::vector<Zone> zones;
  std::vector<LawBinding> laws;

  ParticleData particles;
  NodeData nodes;
  ElementData elements;
  FacetData facets;
  std::vector<Wall> walls;
  std::vector<Notch> notches;
  BeamNodeData beam_nodes;
  BeamElementData beam_elements;
  std::vector<Beam> beams;
  std::vector<Platen> platens;

  /// Sorted. These pairs keep their distance at set-up as reference for ever, so that a cut or broken bond that closes
  /// again finds no overlap it never had.
  std::vector<SetupPair> particle_pairs;
  std::vector<SetupPair> facet_pairs;
  std::vector<SetupPair> corner_pairs;

  /// Sorted. Those of the pairs above that a notch separates: they have a distance of reference and no bond.
  std::vector<SetupPair> cut_particle_pairs;
  std::vector<SetupPair> cut_facet_pairs;
  std::vector<SetupPair> cut_corner_pairs;

  [[nodiscard]] std::size_t n_mesh_nodes() const { return nodes.size() - 2 * walls.size(); }
  [[nodiscard]] std::size_t n_element_facets() const { return facets.size() - walls.size(); }
  /// The nodes at the ends of a wall.
  [[nodiscard]] std::array<Index, 2> wall_nodes(std::size_t wall) const {
    return facets.nodes[n_element_facets() + wall];
  }
  /// The platen that a wall is; null if its motion is prescribed.
  [[nodiscard]] const Platen* platen_of_wall(std::size_t wall) const {
    for (const Platen& platen : platens) {
      if (static_cast<std::size_t>(platen.wall) == wall) return &platen;
    }
    return nullptr;
  }
  /// The wall that a node is an end of; null for nodes of the mesh.
  [[nodiscard]] const Wall* wall_of_node(Index node) const {
    const std::size_t n_before = n_mesh_nodes();
    const auto row = static_cast<std::size_t>(node);
    return row < n_before ? nullptr : &walls[(row - n_before) / 2];
  }
};

}  // namespace ligament
