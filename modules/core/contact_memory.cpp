#include "core/contact_memory.hpp"

#include <algorithm>

namespace ligament {
namespace {

void take(const ContactTable& contacts, ContactMemory::Table& memory) {
  memory.opening = contacts.opening;
  memory.shear_displacement = contacts.shear_displacement;
  memory.normal_force = contacts.normal_force;
  memory.shear_force = contacts.shear_force;
  memory.bond = contacts.bond;
  memory.history.resize(contacts.history.size());
  for (std::size_t k = 0; k < memory.history.size(); ++k) memory.history[k] = contacts.history[k].values;
}

void put_back(const ContactMemory::Table& memory, ContactTable& contacts) {
  // Not by assignment of fields: arrays of the tables stay where they are.
  std::copy(memory.opening.begin(), memory.opening.end(), contacts.opening.begin());
  std::copy(memory.shear_displacement.begin(), memory.shear_displacement.end(), contacts.shear_displacement.begin());
  std::copy(memory.normal_force.begin(), memory.normal_force.end(), contacts.normal_force.begin());
  std::copy(memory.shear_force.begin(), memory.shear_force.end(), contacts.shear_force.begin());
  std::copy(memory.bond.begin(), memory.bond.end(), contacts.bond.begin());
  for (std::size_t k = 0; k < memory.history.size(); ++k) {
    std::copy(memory.history[k].begin(), memory.history[k].end(), contacts.history[k].values.begin());
  }
}

}  // namespace

void ContactMemory::take(const State& state) {
  ligament::take(state.particle_contacts, particle_contacts);
  ligament::take(state.facet_contacts, facet_contacts);
  ligament::take(state.corner_contacts, corner_contacts);
  ligament::take(state.seat_contacts, seat_contacts);
}

void ContactMemory::put_back(State& state) const {
  ligament::put_back(particle_contacts, state.particle_contacts);
  ligament::put_back(facet_contacts, state.facet_contacts);
  ligament::put_back(corner_contacts, state.corner_contacts);
  ligament::put_back(seat_contacts, state.seat_contacts);
}

}  // namespace ligament
