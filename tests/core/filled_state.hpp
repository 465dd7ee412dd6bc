#pragma once

#include "core/fields.hpp"

namespace ligament {

/// A state of two particles, three nodes and two contacts of each kind, every number in it different from the others.
inline State filled_state() {
  State state;
  for (ContactTable* table :
       {&state.particle_contacts, &state.facet_contacts, &state.corner_contacts, &state.seat_contacts}) {
    table->history.push_back({"law.damage", 0.0, {}});
    table->history.push_back({"law.work", 0.0, {}});
  }
  state.ledger.open("damping");
  state.ledger.open("applied_loads");
  double value = 0.0;
  const auto fill = [&value]<class T>(T& number) {
    value += 1.0;
    if constexpr (std::is_same_v<T, Vector>) {
      number = {value, -value};
    } else if constexpr (std::is_same_v<T, PathSum>) {
      number = {value, 1e-3 * value, 2.0 * value};
    } else {
      number = static_cast<T>(value);
    }
  };
  visit_fields(state, [&]<class T>(const std::string&, T& field, FieldRole) {
    if constexpr (std::is_arithmetic_v<T>) {
      fill(field);
    } else {
      if (field.empty()) field.resize(2);
      for (auto& number : field) fill(number);
    }
  });
  return state;
}

}  // namespace ligament
