#pragma once

#include <array>

#include "contact/coming_rows.hpp"
#include "contact/contact_bound.hpp"
#include "contact/pair_block.hpp"
#include "core/model.hpp"
#include "core/state.hpp"
#include "core/stiffness_bounds.hpp"

/// The kinds of contact. Each says where its table is, how its bodies move against each other, which bodies its
/// ends are at and how a contact force reaches them, Eqs (25)-(28), and what stiffness they feel. ContactForces makes
/// the rest.
namespace ligament {

inline ContactReference reference_of(const ContactTable& contacts, std::size_t row) {
  return {contacts.rest_distance[row], contacts.initial_gap[row], contacts.opening[row]};
}

enum class BodyKind { particle, node };

/// Motions of the contacts of a block, and what these do at their ends, for kinds of which there are few.
template <class Pairing>
void measure_one_by_one(const Model& model, const State& state, const LawBlock& block, BlockMotion& block_motion) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    block_motion.set(i, Pairing::motion(model, state, block.begin + i));
  }
}

template <class Pairing>
void find_end_forces_one_by_one(const ContactTable& contacts, const LawBlock& block, const BlockMotion& block_motion,
                                BlockEndForces<Pairing::n_ends>& forces) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const std::size_t row = block.begin + i;
    const ContactGeometry geometry = block_motion.geometry(i);
    forces.set(i, Pairing::end_forces(geometry, contact_point_force(geometry.normal, contacts.normal_force[row],
                                                                    contacts.shear_force[row])));
  }
}

struct ParticlePairing {
  static constexpr const char* name = "contacts";
  /// Whether both bodies stand in one table, the first one, by which contacts are sorted, before the second.
  static constexpr bool are_ordered = true;
  static auto& table(auto& state) { return state.particle_contacts; }

  static PointPairMotion centres(const Model& model, const State& state, std::size_t row) {
    const Index a = state.particle_contacts.first[row];
    const Index b = state.particle_contacts.second[row];
    const TranslationState& translation = state.particles.translation;
    return {model.particles.position[b] - model.particles.position[a],
            translation.displacement[b] - translation.displacement[a],
            translation.increment[b] - translation.increment[a]};
  }

  static DiscPair discs(const Model& model, const State& state, std::size_t row) {
    const Index a = state.particle_contacts.first[row];
    const Index b = state.particle_contacts.second[row];
    const RotationState& rotation = state.particles.rotation;
    return {rotation.increment[a], rotation.increment[b], model.particles.radius[a] - model.particles.radius[b]};
  }

  static ContactMotion motion(const Model& model, const State& state, std::size_t row) {
    return particle_pair_motion(centres(model, state, row), reference_of(state.particle_contacts, row),
                                discs(model, state, row));
  }

  static void measure(const Model& model, const State& state, const LawBlock& block, BlockMotion& motion) {
    const ContactTable& contacts = state.particle_contacts;
    const ComingRows coming(contacts, block.end);
    PairBlock pairs;
    pairs.size = block.size();
    for (std::size_t begin = 0; begin < pairs.size; begin += ComingRows::at_a_time) {
      coming.ask_for(begin);
      const std::size_t end = std::min(begin + ComingRows::at_a_time, pairs.size);
      for (std::size_t i = begin; i < end; ++i) {
        pairs.set(i, centres(model, state, block.begin + i), discs(model, state, block.begin + i));
      }
    }
    measure_pairs(
        pairs,
        {&contacts.rest_distance[block.begin], &contacts.initial_gap[block.begin], &contacts.opening[block.begin]},
        motion);
  }

  static void find_end_forces(const ContactTable& contacts, const LawBlock& block, const BlockMotion& motion,
                              BlockEndForces<2>& forces) {
    find_pair_forces(block.size(), motion, &contacts.normal_force[block.begin], &contacts.shear_force[block.begin],
                     forces);
  }

  static constexpr std::size_t n_ends = 2;
  static constexpr std::array<BodyKind, n_ends> end_kinds{BodyKind::particle, BodyKind::particle};

  static std::array<Index, n_ends> end_bodies(const Model& /*model*/, const ContactTable& contacts, std::size_t row) {
    return {contacts.first[row], contacts.second[row]};
  }

  static std::array<EndForce, n_ends> end_forces(const ContactGeometry& geometry, const ContactPointForce& contact) {
    return {force_on_first(geometry, contact), force_on_second(geometry, contact)};
  }

  static void add_stiffness(const Model& model, const State& state, std::size_t row, const ContactGeometry& geometry,
                            StiffnessBounds& bounds) {
    const ContactTable& contacts = state.particle_contacts;
    const Index a = contacts.first[row];
    const Index b = contacts.second[row];
    const ContactBound bound =
        contact_bound(contacts.normal_stiffness[row], contacts.shear_stiffness[row],
                      geometry.arm_first / model.particles.radius[a], geometry.arm_second / model.particles.radius[b]);
    bounds.particle_translation[a] += bound.translation;
    bounds.particle_translation[b] += bound.translation;
    bounds.particle_rotation[a] += bound.rotation_first;
    bounds.particle_rotation[b] += bound.rotation_second;
  }
};

struct FacetPairing {
  static constexpr const char* name = "interface";
  static constexpr bool are_ordered = false;
  static auto& table(auto& state) { return state.facet_contacts; }

  static ContactMotion motion(const Model& model, const State& state, std::size_t row) {
    const ContactTable& contacts = state.facet_contacts;
    const Index a = contacts.first[row];
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    const TranslationState& nodes = state.nodes.translation;
    const TranslationState& particles = state.particles.translation;
    const FacetMotion facet{
        model.nodes.position[j] - model.nodes.position[i], nodes.displacement[j] - nodes.displacement[i],
        nodes.increment[j] - nodes.increment[i],           model.particles.position[a] - model.nodes.position[i],
        particles.displacement[a] - nodes.displacement[i], particles.increment[a] - nodes.increment[i]};
    return facet_motion(facet, reference_of(contacts, row), state.particles.rotation.increment[a]);
  }

  static void measure(const Model& model, const State& state, const LawBlock& block, BlockMotion& block_motion) {
    measure_one_by_one<FacetPairing>(model, state, block, block_motion);
  }

  static void find_end_forces(const ContactTable& contacts, const LawBlock& block, const BlockMotion& block_motion,
                              BlockEndForces<3>& forces) {
    find_end_forces_one_by_one<FacetPairing>(contacts, block, block_motion, forces);
  }

  static constexpr std::size_t n_ends = 3;
  static constexpr std::array<BodyKind, n_ends> end_kinds{BodyKind::particle, BodyKind::node, BodyKind::node};

  static std::array<Index, n_ends> end_bodies(const Model& model, const ContactTable& contacts, std::size_t row) {
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    return {contacts.first[row], i, j};
  }

  static std::array<EndForce, n_ends> end_forces(const ContactGeometry& geometry, const ContactPointForce& contact) {
    return {force_on_first(geometry, contact),
            {(1.0 - geometry.share) * contact.force, 0.0},
            {geometry.share * contact.force, 0.0}};
  }

  static void add_stiffness(const Model& model, const State& state, std::size_t row, const ContactGeometry& geometry,
                            StiffnessBounds& bounds) {
    const ContactTable& contacts = state.facet_contacts;
    const Index a = contacts.first[row];
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    const ContactBound bound = contact_bound(contacts.normal_stiffness[row], contacts.shear_stiffness[row],
                                             geometry.arm_first / model.particles.radius[a], 0.0);
    bounds.particle_translation[a] += bound.translation;
    bounds.particle_rotation[a] += bound.rotation_first;
    bounds.node_translation[i] += std::abs(1.0 - geometry.share) * bound.translation;
    bounds.node_translation[j] += std::abs(geometry.share) * bound.translation;
  }
};

struct CornerPairing {
  static constexpr const char* name = "interface";
  static constexpr bool are_ordered = false;
  static auto& table(auto& state) { return state.corner_contacts; }

  static ContactMotion motion(const Model& model, const State& state, std::size_t row) {
    const ContactTable& contacts = state.corner_contacts;
    const Index a = contacts.first[row];
    const Index node = contacts.second[row];
    const TranslationState& nodes = state.nodes.translation;
    const TranslationState& particles = state.particles.translation;
    const PointPairMotion pair{model.nodes.position[node] - model.particles.position[a],
                               nodes.displacement[node] - particles.displacement[a],
                               nodes.increment[node] - particles.increment[a]};
    return corner_motion(pair, reference_of(contacts, row), state.particles.rotation.increment[a]);
  }

  static void measure(const Model& model, const State& state, const LawBlock& block, BlockMotion& block_motion) {
    measure_one_by_one<CornerPairing>(model, state, block, block_motion);
  }

  static void find_end_forces(const ContactTable& contacts, const LawBlock& block, const BlockMotion& block_motion,
                              BlockEndForces<2>& forces) {
    find_end_forces_one_by_one<CornerPairing>(contacts, block, block_motion, forces);
  }

  static constexpr std::size_t n_ends = 2;
  static constexpr std::array<BodyKind, n_ends> end_kinds{BodyKind::particle, BodyKind::node};

  static std::array<Index, n_ends> end_bodies(const Model& /*model*/, const ContactTable& contacts, std::size_t row) {
    return {contacts.first[row], contacts.second[row]};
  }

  static std::array<EndForce, n_ends> end_forces(const ContactGeometry& geometry, const ContactPointForce& contact) {
    return {force_on_first(geometry, contact), {contact.force, 0.0}};
  }

  static void add_stiffness(const Model& model, const State& state, std::size_t row, const ContactGeometry& geometry,
                            StiffnessBounds& bounds) {
    const ContactTable& contacts = state.corner_contacts;
    const Index a = contacts.first[row];
    const ContactBound bound = contact_bound(contacts.normal_stiffness[row], contacts.shear_stiffness[row],
                                             geometry.arm_first / model.particles.radius[a], 0.0);
    bounds.particle_translation[a] += bound.translation;
    bounds.particle_rotation[a] += bound.rotation_first;
    bounds.node_translation[contacts.second[row]] += bound.translation;
  }
};

/// A node of elements on a wall: a particle without a radius.
struct SeatPairing {
  static constexpr const char* name = "interface";
  static constexpr bool are_ordered = false;
  static auto& table(auto& state) { return state.seat_contacts; }

  static ContactMotion motion(const Model& model, const State& state, std::size_t row) {
    const ContactTable& contacts = state.seat_contacts;
    const Index a = contacts.first[row];
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    const TranslationState& nodes = state.nodes.translation;
    const FacetMotion facet{
        model.nodes.position[j] - model.nodes.position[i], nodes.displacement[j] - nodes.displacement[i],
        nodes.increment[j] - nodes.increment[i],           model.nodes.position[a] - model.nodes.position[i],
        nodes.displacement[a] - nodes.displacement[i],     nodes.increment[a] - nodes.increment[i]};
    return facet_motion(facet, reference_of(contacts, row), 0.0);
  }

  static void measure(const Model& model, const State& state, const LawBlock& block, BlockMotion& block_motion) {
    measure_one_by_one<SeatPairing>(model, state, block, block_motion);
  }

  static void find_end_forces(const ContactTable& contacts, const LawBlock& block, const BlockMotion& block_motion,
                              BlockEndForces<3>& forces) {
    find_end_forces_one_by_one<SeatPairing>(contacts, block, block_motion, forces);
  }

  static constexpr std::size_t n_ends = 3;
  static constexpr std::array<BodyKind, n_ends> end_kinds{BodyKind::node, BodyKind::node, BodyKind::node};

  static std::array<Index, n_ends> end_bodies(const Model& model, const ContactTable& contacts, std::size_t row) {
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    return {contacts.first[row], i, j};
  }

  static std::array<EndForce, n_ends> end_forces(const ContactGeometry& geometry, const ContactPointForce& contact) {
    return {
        {{-contact.force, 0.0}, {(1.0 - geometry.share) * contact.force, 0.0}, {geometry.share * contact.force, 0.0}}};
  }

  static void add_stiffness(const Model& model, const State& state, std::size_t row, const ContactGeometry& geometry,
                            StiffnessBounds& bounds) {
    const ContactTable& contacts = state.seat_contacts;
    const auto& [i, j] = model.facets.nodes[contacts.second[row]];
    const ContactBound bound = contact_bound(contacts.normal_stiffness[row], contacts.shear_stiffness[row], 0.0, 0.0);
    bounds.node_translation[contacts.first[row]] += bound.translation;
    bounds.node_translation[i] += std::abs(1.0 - geometry.share) * bound.translation;
    bounds.node_translation[j] += std::abs(geometry.share) * bound.translation;
  }
};

}  // namespace ligament
