#pragma once

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// The table that a body stands in.
enum class BodyTable { node, particle, beam_node };

/// Its translations.
template <class AnyState>
auto& translation_of(AnyState& state, BodyTable table) {
  if (table == BodyTable::node) return state.nodes.translation;
  return table == BodyTable::particle ? state.particles.translation : state.beam_nodes.translation;
}

/// Its rotations; nodes of elements have none.
template <class AnyState>
auto& rotation_of(AnyState& state, BodyTable table) {
  return table == BodyTable::particle ? state.particles.rotation : state.beam_nodes.rotation;
}

/// See ParticleData::free.
template <class AnyModel>
auto& free_of(AnyModel& model, BodyTable table) {
  if (table == BodyTable::node) return model.nodes.free;
  return table == BodyTable::particle ? model.particles.free : model.beam_nodes.free;
}
template <class AnyModel>
auto& rotation_free_of(AnyModel& model, BodyTable table) {
  return table == BodyTable::particle ? model.particles.rotation_free : model.beam_nodes.rotation_free;
}

}  // namespace ligament
