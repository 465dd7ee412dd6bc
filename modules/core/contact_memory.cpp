#include "core/contact_memory.hpp"

#include <algorithm>

namespace ligament {

void ContactMemory::take(const State& state) {
  take(state.particle_contacts, particles_);
  take(state.facet_contacts, facets_);
  take(state.corner_contacts, corners_);
  take(state.seat_contacts, seats_);
}

void ContactMemory::put_back(State& state) const {
  put_back(particles_, state.particle_contacts);
  put_back(facets_, state.facet_contacts);
  put_back(corners_, state.corner_contacts);
  put_back(seats_, state.seat_contacts);
}

void ContactMemory::take(const ContactTable& contacts, Table& memory) {
  memory.opening = contacts.opening;
  memory.shear_displacement = contacts.shear_displacement;
  memory.normal_force = contacts.normal_force;
  memory.shear_force = contacts.shear_force;
  memory.bond = contacts.bond;
  memory.history.resize(contacts.history.size());
  for (std::size_t k = 0; k < memory.history.size(); ++k) memory.history[k] = contacts.history[k].values;
}

void ContactMemory::put_back(const Table& memory, ContactTable& contacts) {
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

}  // namespace ligament
