#pragma once

#include "core/state.hpp"

namespace ligament {

/// What the contacts remember at one time: openings, forces, bonds, history. Forces can be tried from it again and
/// again, as long as the contact tables keep their rows.
struct ContactMemory {
  struct Table {
    Field<double> opening;
    Field<ShearVector> shear_displacement;
    Field<double> normal_force;
    Field<ShearVector> shear_force;
    Field<BondState> bond;
    std::vector<Field<double>> history;
  };
  Table particle_contacts;
  Table facet_contacts;
  Table corner_contacts;
  Table seat_contacts;

  /// Takes it from the state.
  void take(const State& state);
  /// Gives it back to the state.
  void put_back(State& state) const;
};

}  // namespace ligament
